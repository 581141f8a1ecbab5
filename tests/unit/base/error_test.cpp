#include "base/error.hpp"

#include <gmock/gmock.h>

#include "base/units.hpp"

TEST(InputError, SaysPlaceProblemAndRemedyOnOneLine) {
  const talus::InputError error("/materials/rock/density", "is -1", "give a positive density in kg/m³");
  EXPECT_STREQ(error.what(), "/materials/rock/density: is -1; give a positive density in kg/m³");
  EXPECT_EQ(error.place(), "/materials/rock/density");
}

TEST(Units, DegreesAndRadiansAreInverse) {
  EXPECT_DOUBLE_EQ(talus::radians(180.0), 3.14159265358979323846);
  EXPECT_DOUBLE_EQ(talus::degrees(talus::radians(37.5)), 37.5);
}
