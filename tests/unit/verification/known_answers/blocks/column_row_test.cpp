#include "verification/known_answers/blocks/column_row.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

TEST(ColumnRow, ComesToThePublishedLimitWithThePublishedHeights) {
  // Goodman & Bray's table: heights 4, 8 … 40, 34, 28 … 4 m; φ = 38.15°.
  ColumnRow row;
  row.crest_drop = 5.0;
  EXPECT_THAT(heights(row), testing::ElementsAre(4, 8, 12, 16, 20, 24, 28, 32, 36, 40, 34, 28, 22, 16, 10, 4));
  EXPECT_NEAR(limiting_friction_angle(row), 38.15, 0.005);
}

TEST(ColumnRow, ItsLimitWithTheCrestOfTheSlopeIsALittleLower) {
  EXPECT_NEAR(limiting_friction_angle(ColumnRow{}), 38.13, 0.005);
}

TEST(ColumnRow, NeedsLessSupportTheRougherItsJoints) {
  double before = 1e300;
  for (double angle = 32; angle < 44; angle += 0.5) {
    const double force = toe_force(ColumnRow{}, angle);
    EXPECT_LT(force, before) << angle;
    before = force;
  }
}

TEST(ColumnRow, OfSquatColumnsOnlySlides) {
  ColumnRow row;
  row.count = 3;
  row.crest = 3;  // 4, 8 and 12 m, below width/tan 30° = 17.3 m
  EXPECT_NEAR(limiting_friction_angle(row), row.base_dip, 1e-9);
}

}  // namespace
}  // namespace talus
