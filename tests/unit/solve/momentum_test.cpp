// Two blocks fly at each other, spin, slide along each other and part: what one loses the other gains.
#include <gtest/gtest.h>

#include <tuple>

#include "solve/simulation.hpp"
#include "support/momenta.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

class Momentum : public testing::TestWithParam<std::tuple<double, BodyKind>> {};

TEST_P(Momentum, IsKeptInACollision) {
  Project project = test::rock_project(30, {{"collision", StageKind::dynamic, 0.002, 300, {}}});
  project.gravity = Vec3::Zero();
  const auto [restitution, body] = GetParam();
  if (restitution >= 0) project.joints[0].restitution = restitution;
  project.velocities = {{"a", Vec3(3, 0.4, 0.2), Vec3(1, 4, -2)}, {"b", Vec3(-2, 0, 0.5), Vec3(-3, 1, 5)}};
  const BlockSystem system = test::block_system({test::box_block("a", Vec3(0, 0, 0), Vec3(1, 1.2, 0.8), body),
                                                 test::box_block("b", Vec3(1.8, 0.3, 0.4), Vec3(2.5, 1.1, 1.6), body)});
  Simulation simulation(project, system);
  const test::Momenta start = test::momenta(simulation.bodies());
  int touched = 0;
  while (!simulation.finished()) {
    simulation.step();
    for (const ContactSample& contact : simulation.contacts()) touched += contact.normal_force > 0;
  }
  ASSERT_TRUE(simulation.converged());
  ASSERT_GT(touched, 0);
  const test::Momenta end = test::momenta(simulation.bodies());
  EXPECT_LT((end.linear - start.linear).norm(), 1e-12 * start.linear.norm());
  EXPECT_LT((end.angular - start.angular).norm(), 1e-9 * start.angular.norm());
}

INSTANTIATE_TEST_SUITE_P(Restitution, Momentum,
                         testing::Combine(testing::Values(-1, 0, 0.5, 1),
                                          testing::Values(BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra)));

}  // namespace
}  // namespace talus
