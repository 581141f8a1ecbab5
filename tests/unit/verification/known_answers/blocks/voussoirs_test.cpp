#include "verification/known_answers/blocks/voussoirs.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

TEST(Voussoirs, OfVeryManyTheLeastThicknessIsThatOfMilankovitch) {
  EXPECT_NEAR(*least_thickness(2001, {}), 0.10748, 2e-5);
}

TEST(Voussoirs, TwentySevenMayBeALittleThinner) {
  // 0.10678 for voussoirs between arcs; plane-sided ones weigh a little less at the back.
  EXPECT_NEAR(*least_thickness(27, {}), 0.10678, 1e-4);
}

TEST(Voussoirs, SlipBelowAFrictionOf0395) {
  EXPECT_DOUBLE_EQ(*least_thickness(27, 0.396), *least_thickness(27, {}));
  EXPECT_GT(*least_thickness(27, 0.392), 1.01 * *least_thickness(27, {}));
  EXPECT_NEAR(*least_thickness(27, 0.35), 0.1506, 1e-3);
  EXPECT_NEAR(*least_thickness(27, 0.32), 0.1832, 1e-3);
}

TEST(Voussoirs, FallAtAnyThicknessBelowAFrictionOf0309) {
  EXPECT_TRUE(least_thickness(2001, 0.3095).has_value());
  EXPECT_FALSE(least_thickness(2001, 0.3085).has_value());
}

TEST(Voussoirs, NeedTheFrictionAtWhichTheirThicknessIsTheLeast) {
  EXPECT_NEAR(*least_friction({27, *least_thickness(27, 0.35)}), 0.35, 1e-6);
  EXPECT_FALSE(least_friction({27, 0.1}).has_value()) << "too thin for any";
}

TEST(Voussoirs, ShareTheCornersOfTheirJoints) {
  const Arch arch{5, 0.2};
  for (int i = 0; i + 1 < arch.voussoirs; ++i) {
    EXPECT_LT((corners(arch, i)[2] - corners(arch, i + 1)[0]).norm(), 1e-15);
    EXPECT_LT((corners(arch, i)[3] - corners(arch, i + 1)[1]).norm(), 1e-15);
  }
  EXPECT_NEAR(corners(arch, 0)[0].x(), 0.9, 1e-15);
  EXPECT_NEAR(corners(arch, 4)[3].x(), -1.1, 1e-15);
}

}  // namespace
}  // namespace talus
