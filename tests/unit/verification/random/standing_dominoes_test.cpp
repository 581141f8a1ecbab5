#include "verification/random/standing_dominoes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.hpp"

namespace talus {
namespace {

TEST(StandingDominoes, LeansAndTipsByItsSides) {
  const StandingDominoes row{5, 1, std::tan(radians(8)), 0.5};
  EXPECT_NEAR(row.tipping_angle(), 8, 1e-12);
  EXPECT_NEAR(row.leaning_angle(), 30, 1e-12);
}

/// A rigid domino with that spin, its motion integrated in small steps, comes just to its tipping angle.
TEST(StandingDominoes, TheTippingSpinJustCarriesItOver) {
  const StandingDominoes row{2, 0.7, 0.1, 0.4};
  const double radius = std::hypot(row.height, row.thickness) / 2, tipping = radians(row.tipping_angle());
  const auto highest = [&](double share) {
    double angle = 0, spin = share * row.tipping_spin();
    for (const double step = 1e-6; spin > 0 && angle < tipping; angle += step * spin)
      spin -= step * 9.81 / (4.0 / 3 * radius) * std::sin(tipping - angle);
    return angle / tipping;
  };
  EXPECT_GE(highest(1.001), 1);
  EXPECT_LT(highest(0.999), 1);
  EXPECT_GT(highest(0.999), 0.9);
}

TEST(StandingDominoes, AThinOneOverturnsTheNextAndAThickOneDoesNot) {
  // Without friction the next takes (h sin β − t cos β)/2 of moment and needs t/2: equal at t = h sin β/(1 + cos β).
  const double limit = 0.5 / (1 + std::sqrt(0.75));
  EXPECT_TRUE((StandingDominoes{5, 1, 0.99 * limit, 0.5}.leaning_overturns(0, 1)));
  EXPECT_FALSE((StandingDominoes{5, 1, 1.01 * limit, 0.5}.leaning_overturns(0, 1)));
  EXPECT_FALSE((StandingDominoes{5, 1, 0.99 * limit, 0.5}.leaning_overturns(30, 1))) << "friction holds the next";
}

}  // namespace
}  // namespace talus
