#include "bodies/rigid_motion.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "support/small_scenes.hpp"

namespace talus {
namespace {

TEST(RigidMotion, ASpinningBlockGoesOnAlongCirclesAndWhatStrainsItAlongLines) {
  Project project;
  project.materials = {{"rock", 2600, 5e9, 0.24}};
  BlockSystem system;
  system.blocks = {test::box_block("ground", Vec3(-9, -9, -9), Vec3(9, 9, -8), BodyKind::fixed),
                   test::box_block("B", Vec3(1, 2, 3), Vec3(2, 4, 6))};
  BodySet set(project, system);
  const Vec3 rate(0.3, -0.2, 0.5), velocity(1, 2, 3), centre(1.5, 3, 4.5);
  for (int n = 8; n < 16; ++n)
    set.nodes.velocity[n] =
        velocity + rate.cross(set.nodes.position[n] - centre) + 0.01 * (set.nodes.position[n] - centre);
  Increment d;
  constexpr double length = 2;
  continue_motion(set, length, d);
  const Mat3 turn = Eigen::AngleAxisd(length * rate.norm(), rate.normalized()).toRotationMatrix();
  for (int n = 8; n < 16; ++n) {
    const Vec3 arm = set.nodes.position[n] - centre;
    const Vec3 expected = turn * arm - arm + length * (velocity + 0.01 * arm);
    EXPECT_LT((d.segment<3>(3 * set.nodes.dof_block[n]) - expected).norm(), 1e-13);
  }
}

}  // namespace
}  // namespace talus
