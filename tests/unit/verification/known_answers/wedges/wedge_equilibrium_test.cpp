#include "verification/known_answers/wedges/wedge_equilibrium.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.hpp"
#include "support/wedge_rows.hpp"
#include "verification/known_answers/wedges/wedge_in_mould.hpp"

namespace {

using namespace talus;

TEST(WedgeEquilibrium, SpeaksTheTablesWords) {
  EXPECT_EQ(to_string(WedgeMode::stable), "stable");
  EXPECT_EQ(to_string(WedgeMode::line_2), "w2");
  EXPECT_EQ(to_string(WedgeMode::plane_1), "p1");
  EXPECT_EQ(to_string(WedgeMode::torsional), "TTS");
  EXPECT_EQ(to_string(WedgeMode::free_fall), "free fall");
}

TEST(WedgeEquilibrium, WedgeOnItsLineHasTheKnownAcceleration) {
  EXPECT_NEAR(9.81 * test::wedge_row("B2-60-0").equilibrium().acceleration(32.5), 1.5244, 5e-5);
  EXPECT_NEAR(9.81 * test::wedge_row("B1-60-30").equilibrium().acceleration(32.5), 2.0431, 5e-5);
}

TEST(WedgeEquilibrium, WedgeOnOnePlaneIsABlockOnAnIncline) {
  const WedgeEquilibrium equilibrium = test::wedge_row("B1-60-60").equilibrium();
  ASSERT_EQ(equilibrium.kinematic, WedgeMode::plane_2);
  const double dip = std::asin(-equilibrium.direction.z());
  EXPECT_NEAR(equilibrium.critical_friction_angle(), degrees(dip), 1e-9);
  EXPECT_NEAR(equilibrium.factor(20), std::tan(radians(20)) / std::tan(dip), 1e-12);
}

TEST(WedgeEquilibrium, StaysFromItsCriticalFrictionOn) {
  const WedgeEquilibrium equilibrium = test::wedge_row("B1-60-0").equilibrium();
  const double critical = equilibrium.critical_friction_angle();
  EXPECT_EQ(equilibrium.mode(critical + 1e-6), WedgeMode::stable);
  EXPECT_EQ(equilibrium.mode(critical - 1e-6), WedgeMode::line_1);
  EXPECT_NEAR(equilibrium.acceleration(critical), 0, 1e-12);
}

TEST(WedgeEquilibrium, NothingHoldsAWedgeBetweenOverhangs) {
  const WedgeEquilibrium equilibrium = test::wedge_row("B1-80-80").equilibrium();
  EXPECT_EQ(equilibrium.mode(89), WedgeMode::free_fall);
  EXPECT_EQ(equilibrium.factor(89), 0);
  EXPECT_EQ(equilibrium.critical_friction_angle(), 90);
  EXPECT_EQ(equilibrium.direction, Vec3(0, 0, -1));
}

}  // namespace
