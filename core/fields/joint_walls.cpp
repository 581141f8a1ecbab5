#include "fields/joint_walls.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "mesh/block_faces.hpp"

namespace talus {

namespace {

constexpr double parts_of_model = 150;          // a wall's triangle is no longer than the model's size over this …
constexpr std::size_t most_triangles = 200000;  // … unless that made more than these
constexpr int most_parts = 128;                 // of an edge
constexpr double inset = 0.01;                  // of the way to the middle of the triangle
constexpr int faces_worth_a_thread = 8;

double longest_edge(const Block& block, const SurfaceTriangle& triangle) {
  const auto at = [&](int i) -> const Vec3& { return block.mesh.nodes[static_cast<std::size_t>(triangle.nodes[i])]; };
  return std::max({(at(0) - at(1)).norm(), (at(1) - at(2)).norm(), (at(2) - at(0)).norm()});
}

int parts_of(double edge, double longest) {
  return std::clamp(static_cast<int>(std::ceil(edge / longest)), 1, most_parts);
}

/// m, so that there are not too many triangles.
double longest_part(const BlockSystem& system) {
  Eigen::AlignedBox3d box;
  std::vector<double> edges;
  for (const Block& block : system.blocks) {
    for (const Vec3& node : block.mesh.nodes) box.extend(node);
    for (const SurfaceTriangle& triangle : block.surface) edges.push_back(longest_edge(block, triangle));
  }
  if (edges.empty()) return 1;
  double longest = box.diagonal().norm() / parts_of_model;
  const auto count = [&] {
    std::size_t sum = 0;
    for (const double edge : edges) sum += static_cast<std::size_t>(std::pow(parts_of(edge, longest), 2));
    return sum;
  };
  while (count() > std::max(most_triangles, edges.size())) longest *= 1.25;
  return longest;
}

/// Divides a triangle into n² that are like it.
void add_triangle(const Block& block, int number, int facet, int first_node, int n, JointWalls& walls) {
  const SurfaceTriangle& triangle = block.surface[static_cast<std::size_t>(facet)];
  std::array<int, 3> nodes;
  for (std::size_t i = 0; i < 3; ++i) nodes[i] = first_node + triangle.nodes[i];
  const auto at = [&](int i) -> const Vec3& { return block.mesh.nodes[static_cast<std::size_t>(triangle.nodes[i])]; };
  const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
  const int first = static_cast<int>(walls.points.size());
  for (int row = 0; row <= n; ++row)
    for (int k = 0; k <= n - row; ++k) {
      const Vec3 corner(static_cast<double>(n - row - k) / n, static_cast<double>(k) / n, static_cast<double>(row) / n);
      WallPoint& point = walls.points.emplace_back();
      point.block = number;
      point.place = {nodes, (1 - inset) * corner + Vec3::Constant(inset / 3)};
      point.corner = corner;
      point.normal = normal;
    }
  // A row of the lattice has one point less than the one before it.
  const auto point_at = [&](int row, int k) { return first + row * (n + 1) - row * (row - 1) / 2 + k; };
  for (int row = 0; row < n; ++row)
    for (int k = 0; k < n - row; ++k) {
      walls.triangles.push_back({{point_at(row, k), point_at(row, k + 1), point_at(row + 1, k)}, number, facet});
      if (k + 1 < n - row)
        walls.triangles.push_back(
            {{point_at(row, k + 1), point_at(row + 1, k + 1), point_at(row + 1, k)}, number, facet});
    }
}

/// Weights of a triangle's corners at the foot of a point; negative beside it.
Vec3 weights_at(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point) {
  const Vec3 normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  if (!(area > 0)) return Vec3::Constant(-1);
  return Vec3((c - b).cross(point - b).dot(normal), (a - c).cross(point - c).dot(normal),
              (b - a).cross(point - a).dot(normal)) /
         area;
}

/// Which points belong to which triangle of the surface.
struct PointsOfFacets {
  std::vector<std::vector<int>> begin;  // a block, a facet; one more at the end
};

class Opposites {
 public:
  Opposites(const BlockSystem& system, const PointsOfFacets& of, JointWalls& walls)
      : system_(system), of_(of), walls_(walls) {
    for (const Block& block : system.blocks) {
      first_node_.push_back(nodes_);
      nodes_ += static_cast<int>(block.mesh.nodes.size());
    }
  }

  /// The points of a face that lie over triangles of another one.
  void find(const FlatFace& face, const FlatFace& other) {
    const Block &block = system_.blocks[static_cast<std::size_t>(face.block)],
                &against = system_.blocks[static_cast<std::size_t>(other.block)];
    const auto& begin = of_.begin[static_cast<std::size_t>(face.block)];
    for (const int facet : face.triangles)
      for (int p = begin[static_cast<std::size_t>(facet)]; p < begin[static_cast<std::size_t>(facet) + 1]; ++p) {
        WallPoint& point = walls_.points[static_cast<std::size_t>(p)];
        if (point.opposite >= 0) continue;
        Vec3 at = Vec3::Zero();
        for (std::size_t i = 0; i < 3; ++i)
          at += point.place.weights[static_cast<int>(i)] *
                block.mesh.nodes[static_cast<std::size_t>(block.surface[static_cast<std::size_t>(facet)].nodes[i])];
        for (const int t : other.triangles) {
          const auto& n = against.surface[static_cast<std::size_t>(t)].nodes;
          const auto node = [&](std::size_t i) -> const Vec3& {
            return against.mesh.nodes[static_cast<std::size_t>(n[i])];
          };
          const Vec3 weights = weights_at(node(0), node(1), node(2), at);
          if (weights.minCoeff() < -1e-9) continue;
          const int first = first_node_[static_cast<std::size_t>(other.block)];
          point.opposite = other.block;
          point.across = {{first + n[0], first + n[1], first + n[2]}, weights};
          break;
        }
      }
  }

 private:
  const BlockSystem& system_;
  const PointsOfFacets& of_;
  JointWalls& walls_;
  std::vector<int> first_node_;
  int nodes_ = 0;
};

}  // namespace

std::optional<std::array<double, 3>> corner_values(const JointWalls::Triangle& triangle,
                                                   std::span<const double> values) {
  std::array<double, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) corners[i] = values[static_cast<std::size_t>(triangle.points[i])];
  const auto lacks = [](double value) { return std::isnan(value); };
  if (std::ranges::count_if(corners, lacks) > 1) return {};
  for (std::size_t i = 0; i < 3; ++i)
    if (lacks(corners[i])) corners[i] = (corners[(i + 1) % 3] + corners[(i + 2) % 3]) / 2;
  return corners;
}

JointWalls joint_walls(const BlockSystem& system) {
  const double longest = longest_part(system);
  JointWalls walls;
  PointsOfFacets of;
  int first_node = 0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const Block& block = system.blocks[b];
    std::vector<int>& begin = of.begin.emplace_back();
    for (std::size_t t = 0; t < block.surface.size(); ++t) {
      begin.push_back(static_cast<int>(walls.points.size()));
      add_triangle(block, static_cast<int>(b), static_cast<int>(t), first_node,
                   parts_of(longest_edge(block, block.surface[t]), longest), walls);
    }
    begin.push_back(static_cast<int>(walls.points.size()));
    first_node += static_cast<int>(block.mesh.nodes.size());
  }
  const BlockFaces faces = block_faces(system);
  std::vector<std::vector<int>> others(faces.faces.size());
  for (const SharedFace& shared : faces.shared) {
    others[static_cast<std::size_t>(shared.face)].push_back(shared.other);
    others[static_cast<std::size_t>(shared.other)].push_back(shared.face);
  }
  Opposites opposites(system, of, walls);
  in_parallel(static_cast<int>(others.size()), faces_worth_a_thread, [&](int begin, int end) {
    for (int face = begin; face < end; ++face)
      for (const int other : others[static_cast<std::size_t>(face)])
        opposites.find(faces.faces[static_cast<std::size_t>(face)], faces.faces[static_cast<std::size_t>(other)]);
  });
  return walls;
}

}  // namespace talus
