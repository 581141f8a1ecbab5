#include "verification/known_answers/wedges/wedge_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.hpp"
#include "support/wedge_rows.hpp"
#include "verification/known_answers/wedges/wedge_cases.hpp"

namespace {

using namespace talus;

struct Named {
  std::string row;
  WedgeMode mode;
};
void PrintTo(const Named& named, std::ostream* out) { *out << named.row; }

class WedgeMotionOf : public testing::TestWithParam<Named> {};

TEST_P(WedgeMotionOf, IsNamedAsTheTablesNameItAtAnyScale) {
  const WedgeTest& test = test::wedge_row(GetParam().row);
  for (const double scale : {1.0, 0.1}) {
    NoProgress nobody;
    const WedgeMotion motion = run_wedge_test(test, plaster_friction_angle, 0, {.scale = scale}, nobody);
    EXPECT_EQ(mode_text(motion.mode), to_string(GetParam().mode)) << "scale " << scale;
    EXPECT_EQ(motion.stray, 0);
    if (GetParam().mode == WedgeMode::stable) {
      EXPECT_TRUE(motion.direction.isZero());
      EXPECT_LT(motion.travel, 1e-3);
    } else {
      const double cosine = motion.direction.dot(test.equilibrium().direction);
      EXPECT_LT(degrees(std::acos(std::min(1.0, cosine))), 0.2);
      EXPECT_NEAR(motion.travel, 0.1, 0.01);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, WedgeMotionOf,
                         testing::Values(Named{"B1-60-0", WedgeMode::stable}, Named{"B1-60-30", WedgeMode::line_1},
                                         Named{"B1-240-80", WedgeMode::plane_1}, Named{"B2-80-40", WedgeMode::plane_2},
                                         Named{"B2-80-80", WedgeMode::free_fall}));

TEST(WedgeMotion, UpsideDownLineIsDirection2) {
  // B1-240-70 at less friction than its threshold needs.
  NoProgress nobody;
  const WedgeMotion motion = run_wedge_test(test::wedge_row("B1-240-70"), 20, 0, {}, nobody);
  EXPECT_EQ(mode_text(motion.mode), to_string(WedgeMode::line_2));
}

class WedgeByThePapersScheme : public testing::TestWithParam<Named> {};

TEST_P(WedgeByThePapersScheme, GoesAsItShould) {
  NoProgress nobody;
  const WedgeMotion motion =
      run_wedge_test(test::wedge_row(GetParam().row), plaster_friction_angle, 1, {.preset = Preset::paper}, nobody);
  EXPECT_EQ(mode_text(motion.mode), to_string(GetParam().mode));
  EXPECT_LT(motion.iterations, 6 * motion.steps) << "hardly a step is cut";
}

INSTANTIATE_TEST_SUITE_P(Rows, WedgeByThePapersScheme,
                         testing::Values(Named{"B1-60-20", WedgeMode::line_1}, Named{"B1-240-40", WedgeMode::stable},
                                         Named{"B1-240-60", WedgeMode::stable}, Named{"B2-60-0", WedgeMode::line_1},
                                         Named{"B2-80-50", WedgeMode::plane_2}));

TEST(WedgeMotion, OfARunThatDoesNotConvergeIsNoAnswer) {
  NoProgress nobody;
  const WedgeMotion motion = run_wedge_test(test::wedge_row("B1-60-60"), 89.9, 0, {.preset = Preset::paper}, nobody);
  EXPECT_EQ(mode_text(motion.mode), "no answer");
  EXPECT_TRUE(motion.direction.isZero());
}

}  // namespace
