#include <gmock/gmock.h>

#include "verification/known_answers/wedges/wedge_cases.hpp"

namespace talus {
namespace {

TEST(PaperScheme, MovesAllWedgesOffTheThresholdsAsLimitEquilibriumSays) {
  NoProgress progress;
  int as_published = 0;
  for (const WedgeTest& test : wedge_tests()) {
    const WedgeMotion motion = run_wedge_test(test, plaster_friction_angle, 1, {.preset = Preset::paper}, progress);
    EXPECT_TRUE(motion.mode) << test.name() << " comes to no answer";
    as_published += motion.mode == test.coupled;
    const WedgeEquilibrium equilibrium = test.equilibrium();
    if (at_threshold(equilibrium.factor(plaster_friction_angle))) continue;
    EXPECT_EQ(mode_text(motion.mode), to_string(equilibrium.mode(plaster_friction_angle))) << test.name();
  }
  EXPECT_GE(as_published, 60) << "61 of 65 when this was written (docs/validation.md)";
}

}  // namespace
}  // namespace talus
