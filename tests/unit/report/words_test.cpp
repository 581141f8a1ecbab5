#include "report/words.hpp"

#include <gtest/gtest.h>

namespace talus::report {
namespace {

TEST(Words, OfQuantitiesTakeThePrefixThatSuitsThem) {
  EXPECT_EQ(quantity(0.00147, "m"), "1.47\u00a0mm");
  EXPECT_EQ(quantity(812.4, "m"), "812\u00a0m");
  EXPECT_EQ(quantity(-2.6e-10, "m", 2), "−2.6×10⁻¹⁰\u00a0m");
  EXPECT_EQ(quantity(3.5e6, "J", 2), "3.5\u00a0MJ");
  EXPECT_EQ(quantity(2.5e10, "Pa"), "25.0\u00a0GPa");
  EXPECT_EQ(quantity(1.5, "s"), "1.50\u00a0s");
}

TEST(Words, OfNumbersThatWereGivenHaveNoZerosThatSayNothing) {
  EXPECT_EQ(given(2600), "2600");
  EXPECT_EQ(given(0.14000000000000001), "0.14");
  EXPECT_EQ(given(32.5), "32.5");
  EXPECT_EQ(given(0), "0");
  EXPECT_EQ(given(1e-6), "1×10⁻⁶");
  EXPECT_EQ(given(100), "100");
}

TEST(Words, OfVectorsStayOnOneLine) {
  EXPECT_EQ(given(Vec3(0, 0, -9.81)), "(0,\u00a00,\u00a0−9.81)");
  EXPECT_EQ(vector_text(Vec3(1, 2.345, -0.001), 2), "(1.00,\u00a02.35,\u00a00.00)");
}

TEST(Words, OfColumnsHaveAsManyDecimalsAsTheirLargestValueCallsFor) {
  EXPECT_EQ(decimals_for(843.2), 1);
  EXPECT_EQ(decimals_for(9.6), 3);
  EXPECT_EQ(decimals_for(0), 0);
  EXPECT_EQ(decimals_for(1e9), 0);
}

TEST(Words, OfAClock) {
  EXPECT_EQ(clock_text(0.4213), "0.42\u00a0s");
  EXPECT_EQ(clock_text(42.4), "42\u00a0s");
  EXPECT_EQ(clock_text(200), "3\u00a0min 20\u00a0s");
  EXPECT_EQ(clock_text(7500), "2\u00a0h 05\u00a0min");
}

}  // namespace
}  // namespace talus::report
