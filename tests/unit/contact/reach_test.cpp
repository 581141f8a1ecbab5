#include "contact/reach.hpp"

#include <gtest/gtest.h>

#include "unit/contact/blocks.hpp"

namespace talus {
namespace {

Reach of_three() {
  Reach reach(0.01);
  reach.multiple = 2;
  reach.ways = {{}, {Vec3(0.3, 0, 0), 0}, {Vec3(0.3, 0.04, 0), 0.005}};
  return reach;
}

TEST(Reach, IsTheSameForAllUnlessWaysAreKnown) {
  const Reach everywhere = 0.02;
  EXPECT_EQ(everywhere(0, 7), 0.02);
  EXPECT_EQ(everywhere.part(3), 0.01);
}

TEST(Reach, FollowsHowFarTwoBodiesGoAgainstEachOther) {
  const Reach reach = of_three();
  EXPECT_NEAR(reach(0, 1), 0.01 + 2 * 0.3, 1e-15);
  EXPECT_NEAR(reach(1, 2), 0.01 + 2 * (0.04 + 0.005), 1e-15) << "they go side by side";
  EXPECT_EQ(reach(2, 1), reach(1, 2));
}

TEST(Reach, OfTwoIsNoFartherThanTheirParts) {
  const Reach reach = of_three();
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) EXPECT_LE(reach(a, b), reach.part(a) + reach.part(b) + 1e-15);
}

/// Two cubes 3 cm apart that slide on a slab together, and one that slides away from them.
TEST(Reach, CubesThatSlideSideBySideHaveNoContactThatOneHasThatSlidesAway) {
  testing::Scene scene;
  scene.add(testing::box({-5, -5, -1}, {5, 5, 0}), true);
  for (const double x : {0.0, 1.03, 2.06}) scene.add(testing::box({x, 0, 0}, {x + 1, 1, 1}));
  Reach reach(1e-3);
  reach.multiple = 2;
  reach.ways = {{}, {Vec3(0.02, 0, 0), 0}, {Vec3(0.02, 0, 0), 0}, {Vec3(0.04, 0, 0), 0}};
  scene.detector().detect(scene.x, reach, scene.contacts);
  int together = 0, apart = 0;
  for (const ContactPoint& p : scene.contacts.points) {
    together += p.bodies[0] == 1 && p.bodies[1] == 2;
    apart += p.bodies[0] == 2 && p.bodies[1] == 3;
  }
  EXPECT_EQ(together, 0);
  EXPECT_GT(apart, 0);
}

}  // namespace
}  // namespace talus
