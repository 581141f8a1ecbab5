#include "geometry/mesher/cells/cell_mesher.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <unordered_map>

namespace talus {
namespace {

/// Numbers of a shape's own for vertices as they come.
class NodeNumbers {
 public:
  explicit NodeNumbers(std::vector<Vec3>& nodes) : nodes_(nodes) {}

  int operator()(int vertex, const Vec3& place) {
    const auto [known, fresh] = numbers_.try_emplace(vertex, static_cast<int>(nodes_.size()));
    if (fresh) nodes_.push_back(place);
    return known->second;
  }

 private:
  std::vector<Vec3>& nodes_;
  std::unordered_map<int, int> numbers_;
};

const Vec3& vertex_of(const CellComplex& complex, const BlockSkin& skin, int vertex) {
  const auto of_cells = static_cast<int>(complex.vertices().size());
  return vertex < of_cells ? complex.vertex(vertex) : skin.more[static_cast<std::size_t>(vertex - of_cells)];
}

/// The corners with the lowest first, in the same sense.
std::vector<int> from_lowest(std::vector<int> corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// A fan of tetrahedra from the lowest corner of a cell over the faces that do not have it, each of them a fan from its
/// own lowest: faces that two cells have are so divided alike.
template <class Take>
void for_each_tetrahedron(const Cell& cell, const Take& take) {
  int apex = cell.front().corners.front();
  for (const CellFace& face : cell) apex = std::min(apex, *std::min_element(face.corners.begin(), face.corners.end()));
  for (const CellFace& face : cell) {
    const std::vector<int> corners = from_lowest(face.corners);
    if (corners.front() == apex) continue;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) take(std::array{corners[0], corners[k + 1], corners[k], apex});
  }
}

double six_volumes(const std::array<Vec3, 4>& at) { return (at[1] - at[0]).cross(at[2] - at[0]).dot(at[3] - at[0]); }

/// By the divergence theorem.
Vec3 centroid_within(const MeshedShape& shape) {
  const Vec3& origin = shape.nodes.front();
  double volume = 0;
  Vec3 moment = Vec3::Zero();
  for (const auto& triangle : shape.triangles) {
    const auto arm = [&](std::size_t k) -> Vec3 { return shape.nodes[static_cast<std::size_t>(triangle[k])] - origin; };
    const double part = arm(0).dot(arm(1).cross(arm(2)));
    volume += part;
    moment += part * (arm(0) + arm(1) + arm(2)) / 4;
  }
  return origin + moment / volume;
}

/// Puts a tetrahedron between the centroid and each triangle; false, and nothing, where one would be flat or inside
/// out.
bool fill_from_centroid(MeshedShape& shape) {
  const Vec3 centroid = centroid_within(shape);
  const int apex = static_cast<int>(shape.nodes.size());
  std::vector<std::array<int, 4>> tetrahedra;
  for (const auto& [a, b, c] : shape.triangles) {
    const auto at = [&](int node) -> const Vec3& { return shape.nodes[static_cast<std::size_t>(node)]; };
    if (!(six_volumes({at(a), at(c), at(b), centroid}) > 0)) return false;
    tetrahedra.push_back({a, c, b, apex});
  }
  shape.nodes.push_back(centroid);
  shape.tetrahedra = std::move(tetrahedra);
  return true;
}

void fill_with_those_of_cells(MeshedShape& shape, const CellComplex& complex, std::span<const int> cells,
                              NodeNumbers& number) {
  for (int cell : cells) {
    for_each_tetrahedron(complex.cells()[static_cast<std::size_t>(cell)], [&](const std::array<int, 4>& corners) {
      std::array<Vec3, 4> at;
      for (std::size_t k = 0; k < 4; ++k) at[k] = complex.vertex(corners[k]);
      // Corners on one line give a fan triangles without area; such tetrahedra are nothing.
      if (!(six_volumes(at) > 0)) return;
      std::array<int, 4> tetrahedron{};
      for (std::size_t k = 0; k < 4; ++k) tetrahedron[k] = number(corners[k], at[k]);
      shape.tetrahedra.push_back(tetrahedron);
    });
  }
}

}  // namespace

MeshedShape coarse_mesh(const CellSolid& solid, std::span<const int> cells, const std::string& place) {
  const CellComplex& complex = solid.complex;
  const BlockSkin skin = block_skin(solid, cells, {}, place);
  MeshedShape shape;
  NodeNumbers number(shape.nodes);
  for (std::size_t t = 0; t < skin.triangles.size(); ++t) {
    std::array<int, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k)
      triangle[k] = number(skin.triangles[t][k], complex.vertex(skin.triangles[t][k]));
    shape.triangles.push_back(triangle);
    shape.triangle_joints.push_back(solid.joints[static_cast<std::size_t>(skin.marks[t])]);
  }
  require_two_triangles_an_edge(shape.nodes, shape.triangles, place);
  if (!fill_from_centroid(shape)) fill_with_those_of_cells(shape, complex, cells, number);
  return shape;
}

SurfaceMesh fine_surface(const CellSolid& solid, std::span<const int> cells, const SkinSize& size,
                         const std::string& place) {
  const BlockSkin skin = block_skin(solid, cells, size, place);
  SurfaceMesh surface;
  NodeNumbers number(surface.nodes);
  for (std::size_t t = 0; t < skin.triangles.size(); ++t) {
    std::array<int, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k)
      triangle[k] = number(skin.triangles[t][k], vertex_of(solid.complex, skin, skin.triangles[t][k]));
    surface.triangles.push_back(triangle);
    surface.origins.push_back({skin.marks[t], solid.joints[static_cast<std::size_t>(skin.marks[t])]});
  }
  return surface;
}

}  // namespace talus
