#include "verification/random/scene_numbers.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <set>

namespace talus {
namespace {

TEST(SceneNumbers, AreTheSameForASeed) {
  SceneNumbers numbers(5489);
  // The first of the Mersenne Twister from this seed is 14514284786278117030 (Nishimura & Matsumoto).
  EXPECT_NEAR(numbers.between(0, 1), 14514284786278117030.0 / 18446744073709551616.0, 1e-15);
}

TEST(SceneNumbers, LieWithinTheirBounds) {
  SceneNumbers numbers(1);
  std::set<int> wholes;
  for (int i = 0; i < 1000; ++i) {
    const double even = numbers.between(-2, 3), order = numbers.logarithmic(1e-3, 1e2);
    EXPECT_TRUE(even >= -2 && even < 3) << even;
    EXPECT_TRUE(order >= 1e-3 * (1 - 1e-12) && order < 1e2 * (1 + 1e-12)) << order;
    wholes.insert(numbers.whole(2, 5));
    EXPECT_NEAR(numbers.direction().norm(), 1, 1e-14);
  }
  EXPECT_THAT(wholes, testing::ElementsAre(2, 3, 4, 5));
}

TEST(SceneNumbers, TurnsAreRotationsAndLookEverywhere) {
  SceneNumbers numbers(2);
  Vec3 mean = Vec3::Zero();
  for (int i = 0; i < 4000; ++i) {
    const Mat3 turn = numbers.turn();
    EXPECT_NEAR((turn * turn.transpose() - Mat3::Identity()).norm(), 0, 1e-13);
    EXPECT_GT(turn.col(0).cross(turn.col(1)).dot(turn.col(2)), 0.99) << "not mirrored";
    mean += turn.col(0) / 4000;
  }
  EXPECT_LT(mean.norm(), 0.05) << "three standard deviations of 4000 even directions";
}

TEST(SceneNumbers, SeedsOfNeighboursHaveHalfOfTheirBitsInCommon) {
  int different = 0;
  for (std::uint64_t number = 1; number <= 100; ++number)
    different += std::popcount(mixed_seed(1, "impacts", number) ^ mixed_seed(1, "impacts", number + 1));
  EXPECT_NEAR(different / 100.0, 32, 2);
  EXPECT_NE(mixed_seed(1, "impacts", 1), mixed_seed(2, "impacts", 1));
  EXPECT_NE(mixed_seed(1, "impacts", 1), mixed_seed(1, "drops", 1));
}

}  // namespace
}  // namespace talus
