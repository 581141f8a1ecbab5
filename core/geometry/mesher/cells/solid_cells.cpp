#include "geometry/mesher/cells/solid_cells.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/mesher/cells/flat_groups.hpp"
#include "geometry/mesher/tet_mesher.hpp"

namespace talus {
namespace {

/// The flat face of the skin across each directed edge of its triangles.
using FaceBeside = std::map<std::pair<int, int>, int>;

FaceBeside faces_beside(const TriangleSolid& solid, const std::vector<int>& groups) {
  FaceBeside beside;
  for (std::size_t t = 0; t < solid.triangles.size(); ++t) {
    const auto& corners = solid.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) beside[{corners[(k + 1) % 3], corners[k]}] = groups[t];
  }
  return beside;
}

/// A prism below each triangle of the surface. Sides that two have part cells, others are walls.
std::vector<Cell> prisms(const TriangleSolid& solid, const std::vector<int>& groups) {
  const int below = static_cast<int>(solid.vertices.size()) / 2;
  const auto surface = static_cast<std::size_t>(solid.surface_triangles);
  std::map<std::pair<int, int>, bool> inner;
  for (std::size_t t = 0; t < surface; ++t)
    for (std::size_t k = 0; k < 3; ++k) inner[{solid.triangles[t][k], solid.triangles[t][(k + 1) % 3]}] = true;
  const FaceBeside beside = faces_beside(solid, groups);
  std::vector<Cell> cells;
  for (std::size_t t = 0; t < surface; ++t) {
    const auto [a, b, c] = solid.triangles[t];
    Cell cell{{{a, b, c}, groups[t]}, {{a + below, c + below, b + below}, groups[surface + t]}};
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const int mark = inner.contains({to, from}) ? between_cells : beside.at({from, to});
      cell.push_back({{from + below, to + below, to, from}, mark});
    }
    cells.push_back(std::move(cell));
  }
  return cells;
}

SolidCells tetrahedra(const TriangleSolid& solid, const std::vector<int>& groups, double reach,
                      const std::string& place) {
  SurfaceMesh surface{solid.vertices, solid.triangles, {}};
  for (int group : groups) surface.origins.push_back({0, group});
  const MeshedShape shape =
      fill_with_tetrahedra(surface, bounds_of(solid).diagonal().norm(), {}, volume_of(solid), place);
  std::map<std::array<int, 3>, int> mark;
  const auto sorted = [](std::array<int, 3> corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  for (std::size_t t = 0; t < shape.triangles.size(); ++t) mark[sorted(shape.triangles[t])] = shape.triangle_joints[t];
  std::vector<Cell> cells;
  for (const auto& [p, q, r, s] : shape.tetrahedra) {
    Cell cell;
    for (const std::array<int, 3>& face : {std::array{q, r, s}, {p, s, r}, {p, q, s}, {p, r, q}}) {
      const auto known = mark.find(sorted(face));
      cell.push_back({{face.begin(), face.end()}, known == mark.end() ? between_cells : known->second});
    }
    cells.push_back(std::move(cell));
  }
  return {CellComplex(shape.nodes, std::move(cells), reach), 0};
}

}  // namespace

SolidCells cells_of(const PolyhedronShape& convex) {
  constexpr double rounding = 1e-9, parallel = 1e-6;
  Eigen::AlignedBox3d box;
  for (const Vec3& vertex : convex.vertices) box.extend(vertex);
  const double reach = rounding * box.diagonal().norm();
  std::vector<Plane> planes;
  Cell cell;
  for (const std::vector<int>& face : convex.faces) {
    const Plane own = plane_of(convex, face);
    const auto same = std::ranges::find_if(planes, [&](const Plane& known) {
      return known.normal.dot(own.normal) > 0 && angle_between(known, own) < parallel;
    });
    cell.push_back({face, static_cast<int>(same - planes.begin())});
    if (same == planes.end()) planes.push_back(own);
  }
  return {CellComplex(convex.vertices, {std::move(cell)}, reach), static_cast<int>(planes.size())};
}

SolidCells cells_of(const TriangleSolid& solid, const std::string& place) {
  constexpr double rounding = 1e-9;
  const double reach = rounding * bounds_of(solid).diagonal().norm();
  const std::vector<int> groups = flat_groups(solid);
  SolidCells cells = solid.terrain_like() ? SolidCells{CellComplex(solid.vertices, prisms(solid, groups), reach), 0}
                                          : tetrahedra(solid, groups, reach, place);
  cells.flat_faces = 1 + *std::max_element(groups.begin(), groups.end());
  return cells;
}

}  // namespace talus
