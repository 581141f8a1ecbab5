#include "render/motion_view.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "base/units.hpp"

namespace talus {

namespace {

constexpr double to_the_side = 55, upwards = 22;  // degrees
constexpr double worth_seeing = 2e-3;             // of the scene's diagonal

}  // namespace

void look_at_motion(Scene& scene, const BlockSystem& system, const Frame& last) {
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
  const double way = moved > 0 ? std::hypot(sum.x(), sum.y()) / moved : 0;
  if (way < worth_seeing * bounds.diagonal().norm())
    scene.look(View::iso);
  else
    scene.look(degrees(std::atan2(sum.x(), sum.y())) + to_the_side, upwards);
}

}  // namespace talus
