#include "render/scene/slope_view.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "base/units.hpp"

namespace talus {

namespace {

constexpr double to_the_side = 55, upwards = 22;  // degrees
constexpr double worth_seeing = 2e-3;             // of the scene's diagonal
constexpr double level = 0.02;                    // mean horizontal share of the ground's normals

using Horizontal = std::optional<Vec3>;

/// Mean way of the movable nodes [m].
Horizontal way_moved(const BlockSystem& system, const Frame& last) {
  Eigen::AlignedBox3d bounds;
  Vec3 sum = Vec3::Zero();
  int moved = 0;
  std::size_t node = 0;
  for (const Block& block : system.blocks)
    for (const Vec3& point : block.mesh.nodes) {
      bounds.extend(point);
      const Vec3& displacement = last.displacement[node++];
      if (block.body == BodyKind::fixed) continue;
      sum += displacement;
      ++moved;
    }
  if (moved == 0 || std::hypot(sum.x(), sum.y()) < moved * worth_seeing * bounds.diagonal().norm()) return {};
  return sum / moved;
}

/// Mean normal of what looks up.
Horizontal way_down(const BlockSystem& system) {
  Vec3 sum = Vec3::Zero();
  for (const Block& block : system.blocks)
    for (const SurfaceTriangle& triangle : block.surface) {
      const auto& nodes = block.mesh.nodes;
      const Vec3 &a = nodes[triangle.nodes[0]], &b = nodes[triangle.nodes[1]], &c = nodes[triangle.nodes[2]];
      const Vec3 area = (b - a).cross(c - a);
      if (area.z() > 0.05 * area.norm()) sum += area;
    }
  if (std::hypot(sum.x(), sum.y()) < level * sum.norm()) return {};
  return sum;
}

}  // namespace

void look_at_slope(Scene& scene, const BlockSystem& system, const Frame* last) {
  Horizontal towards;
  if (last) towards = way_moved(system, *last);
  if (!towards) towards = way_down(system);
  if (towards)
    scene.look(degrees(std::atan2(towards->x(), towards->y())) + to_the_side, upwards);
  else
    scene.look(View::iso);
}

}  // namespace talus
