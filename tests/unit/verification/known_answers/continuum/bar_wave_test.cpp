#include "verification/known_answers/continuum/bar_wave.hpp"

#include <gtest/gtest.h>

using namespace talus;

namespace {

const ElasticBar bar{.length = 10, .area = 2, .young = 10e9, .density = 2500};
const SmoothPulse push{.peak = 1e6, .duration = 2e-3};

}  // namespace

TEST(BarWave, TravelsWithTheRootOfStiffnessOverDensity) {
  EXPECT_DOUBLE_EQ(bar.wave_speed(), 2000);
  EXPECT_DOUBLE_EQ(bar.travel_time(), 5e-3);
  EXPECT_EQ(bar.free_end_displacement(push, 5e-3), 0);
  EXPECT_GT(bar.free_end_displacement(push, 5.1e-3), 0);
}

TEST(BarWave, ImpulseIsTheIntegralOfTheForce) {
  double sum = 0;
  constexpr int parts = 1000;
  for (int i = 0; i < parts; ++i) sum += push.force(1.3e-3 * (i + 0.5) / parts) * 1.3e-3 / parts;
  EXPECT_NEAR(push.impulse(1.3e-3) / sum, 1, 1e-6);
  EXPECT_DOUBLE_EQ(push.impulse(1), 1e6 * 2e-3 / 2);
}

TEST(BarWave, MomentumOfTheBarIsTheImpulse) {
  // When the wave has passed through once and begins to come back, the bar moves as a whole by twice the impulse over
  // its mass a round trip; the free end makes that way at once.
  const double mass = bar.density * bar.area * bar.length, round_trip = 2 * bar.travel_time();
  EXPECT_NEAR(bar.free_end_displacement(push, 8e-3), push.impulse(1) / mass * round_trip, 1e-15);
}
