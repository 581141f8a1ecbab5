#include "verification/known_answers/blocks/slide_or_topple.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace talus {
namespace {

TEST(SlideOrTopple, PureTopplingBeginsWhereTheToeWouldSlip) {
  EXPECT_NEAR(friction_angle_of_pure_toppling(0.25, 30), 18.127, 5e-4);
  EXPECT_NEAR(friction_angle_of_pure_toppling(1, 45), 45, 1e-9);  // all lines of the chart meet at α = φ = δ
}

TEST(SlideOrTopple, ExamplesOfWyllieAndMah) {
  EXPECT_EQ(expected_mode({1, 40, 40.1}), ColumnMode::stable);
  EXPECT_EQ(expected_mode({2, 40, 20}), ColumnMode::slides);
  EXPECT_EQ(expected_mode({0.4, 40, 40}), ColumnMode::topples);
  EXPECT_EQ(expected_mode({0.25, 30, 16}), ColumnMode::slides_and_topples);
}

TEST(SlideOrTopple, PointsBesideTheLinesLieInAllFourFields) {
  std::array<int, 4> fields{};
  for (const ColumnPoint& point : points_beside_the_lines({0.25, 1})) ++fields[static_cast<int>(expected_mode(point))];
  EXPECT_GE(*std::min_element(fields.begin(), fields.end()), 2);
}

}  // namespace
}  // namespace talus
