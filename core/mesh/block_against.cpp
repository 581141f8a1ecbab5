#include "mesh/block_against.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace talus {
namespace {

constexpr double opposite = 0.99985;  // cosine of 1°
constexpr double apart = 1e-6;        // of the block's size

/// Whether the point lies over the triangle, and near to its plane.
bool lies_on(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c, double tolerance) {
  const Vec3 normal = (b - a).cross(c - a).normalized();
  if (std::abs(normal.dot(point - a)) > tolerance) return false;
  const auto beside = [&](const Vec3& from, const Vec3& to) {
    return normal.dot((to - from).cross(point - from)) < -tolerance * (to - from).norm();
  };
  return !beside(a, b) && !beside(b, c) && !beside(c, a);
}

}  // namespace

int block_against(const BlockSystem& system, int block, const Vec3& point, const Vec3& normal) {
  for (std::size_t other = 0; other < system.blocks.size(); ++other) {
    if (static_cast<int>(other) == block) continue;
    const auto& nodes = system.blocks[other].mesh.nodes;
    Eigen::AlignedBox3d box;
    for (const Vec3& node : nodes) box.extend(node);
    if (box.isEmpty()) continue;
    const double tolerance = apart * box.diagonal().norm();
    if (box.exteriorDistance(point) > tolerance) continue;
    for (const SurfaceTriangle& triangle : system.blocks[other].surface) {
      const Vec3 &a = nodes[triangle.nodes[0]], &b = nodes[triangle.nodes[1]], &c = nodes[triangle.nodes[2]];
      if ((b - a).cross(c - a).normalized().dot(normal) < -opposite && lies_on(point, a, b, c, tolerance))
        return static_cast<int>(other);
    }
  }
  return -1;
}

}  // namespace talus
