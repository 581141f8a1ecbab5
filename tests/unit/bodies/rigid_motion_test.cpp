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

TEST(RigidMotion, AnIterationThatTurnsABlockThatDeformsDoesNotStretchIt) {
  Project project;
  project.materials = {{"rock", 2600, 5e9, 0.24}};
  BlockSystem system;
  system.blocks = {test::box_block("affine", Vec3(1, 2, 3), Vec3(2, 4, 6), BodyKind::affine),
                   test::box_block("meshed", Vec3(5, 2, 3), Vec3(6, 4, 6))};
  const BodySet set(project, system);
  const Vec3 turn(0.3, -0.2, 0.5), way(0.1, 0.2, -0.1);
  Increment from(set.unknowns()), to;
  Eigen::VectorXd change(set.unknowns());
  const Mat3 before = Eigen::AngleAxisd(0.4, Vec3(1, 1, 2).normalized()).toRotationMatrix();
  for (const int n : set.nodes.free) {
    const Vec3& x = set.nodes.position[n];
    from.segment<3>(3 * set.nodes.dof_block[n]) = before * x - x;
    change.segment<3>(3 * set.nodes.dof_block[n]) = way + turn.cross(before * x);
  }
  set.advance(from, change, to);
  for (const int n : set.nodes.free)
    for (const int m : set.nodes.free) {
      if (set.nodes.body[n] != set.nodes.body[m]) continue;
      const Vec3 between = set.nodes.position[n] - set.nodes.position[m];
      const Vec3 now = between + to.segment<3>(3 * set.nodes.dof_block[n]) - to.segment<3>(3 * set.nodes.dof_block[m]);
      EXPECT_NEAR(now.norm(), between.norm(), 1e-13);
    }
  constexpr double little = 1e-6;
  set.advance(from, little * change, to);
  EXPECT_LT((to - from - little * change).norm(), 10 * little * little * change.norm());
}

}  // namespace
}  // namespace talus
