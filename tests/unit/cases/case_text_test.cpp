#include "cases/case_text.hpp"

#include <gtest/gtest.h>

namespace {

using namespace talus;

TEST(CaseText, RoundsToFixedDigits) {
  EXPECT_EQ(decimals(26.4385, 2), "26.44");
  EXPECT_EQ(decimals(3, 0), "3");
  EXPECT_EQ(decimals(-0.004, 2), "0.00");
  EXPECT_EQ(decimals(-0.006, 2), "-0.01");
}

TEST(CaseText, PrintsDirectionsAsTheTablesDo) {
  EXPECT_EQ(direction_text(Vec3(0.4581, 0.6274, -0.6299)), "(0.46, 0.63, -0.63)");
  EXPECT_EQ(direction_text(Vec3::Zero()), "–");
}

}  // namespace
