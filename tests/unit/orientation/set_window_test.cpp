#include "orientation/set_window.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

namespace talus {
namespace {

using testing::ElementsAre;

std::vector<Vec3> poles_of(const std::vector<PlaneAttitude>& planes) {
  std::vector<Vec3> poles;
  for (const PlaneAttitude& plane : planes) poles.push_back(pole_of(plane));
  return poles;
}

TEST(SetWindow, OfAConePicksWhatIsWithinItsAngle) {
  const auto poles = poles_of({{45, 120}, {55, 120}, {60, 120}, {45, 300}});
  EXPECT_THAT(picked(ConeWindow{{45, 120}, 10}, poles), ElementsAre(0, 1));
}

TEST(SetWindow, OfAConeReachesAcrossTheRim) {
  // 85/90 and 85/270 are 10° apart.
  const auto poles = poles_of({{85, 90}, {85, 270}, {70, 270}});
  EXPECT_THAT(picked(ConeWindow{{85, 90}, 10}, poles), ElementsAre(0, 1));
}

TEST(SetWindow, OfRangesTakesDirectionsAcrossNorth) {
  const auto poles = poles_of({{50, 350}, {50, 10}, {50, 30}, {20, 0}});
  EXPECT_THAT(picked(RangeWindow{40, 60, 340, 20}, poles), ElementsAre(0, 1));
}

TEST(SetWindow, OfRangesReachesAcrossTheRim) {
  const auto poles = poles_of({{80, 40}, {80, 220}, {60, 40}, {60, 220}});
  EXPECT_THAT(picked(RangeWindow{70, 110, 20, 60}, poles), ElementsAre(0, 1));
  EXPECT_THAT(picked(RangeWindow{70, 90, 20, 60}, poles), ElementsAre(0));
}

TEST(SetWindow, OfAWholeCircleTakesAllDirectionsAndLevelPlanesHaveNone) {
  const auto poles = poles_of({{10, 3}, {0, 0}, {10, 200}});
  EXPECT_THAT(picked(RangeWindow{0, 20, 0, 360}, poles), ElementsAre(0, 1, 2));
  EXPECT_THAT(picked(RangeWindow{0, 20, 190, 210}, poles), ElementsAre(1, 2));
}

TEST(SetWindow, IsWrittenAndReadAsText) {
  const SetWindow cone = ConeWindow{{45, 120}, 15.5}, range = RangeWindow{30, 110, 340, 20};
  EXPECT_EQ(window_text(cone), "45/120~15.5");
  EXPECT_EQ(window_text(range), "30..110/340..20");
  EXPECT_EQ(window_from_text(window_text(cone), "--window"), cone);
  EXPECT_EQ(window_from_text(window_text(range), "--window"), range);
}

TEST(SetWindow, TextThatIsNoneIsRefused) {
  for (const char* text : {"", "45/120", "45/120~100", "60..30/0..10", "0..200/0..10", "0..10/0..400", "100/0~5"})
    EXPECT_THROW(window_from_text(text, "--window"), InputError) << text;
}

}  // namespace
}  // namespace talus
