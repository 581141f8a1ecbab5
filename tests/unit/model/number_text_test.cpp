#include "model/number_text.hpp"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace talus {
namespace {

TEST(NumberText, IsAsShortAsAPersonWouldWriteIt) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(2600), "2600");
  EXPECT_EQ(number_text(-9.81), "-9.81");
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(25e9), "2.5e10");
  EXPECT_EQ(number_text(1e9), "1e9");
  EXPECT_EQ(number_text(1e-5), "1e-5");
  EXPECT_EQ(number_text(2e-10), "2e-10");
  EXPECT_EQ(number_text(1e100), "1e100");
}

TEST(NumberText, KeepsTheSignOfZeroForJson) { EXPECT_EQ(number_text(-0.0), "-0.0"); }

TEST(NumberText, ReadsBackToTheSameBits) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();
    double value;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    ASSERT_EQ(std::strtod(number_text(value).c_str(), nullptr), value) << number_text(value);
  }
  for (const double value : {std::numeric_limits<double>::max(), std::numeric_limits<double>::min(),
                             std::numeric_limits<double>::denorm_min(), 1.0 / 3, 9007199254740993.0}) {
    EXPECT_EQ(std::strtod(number_text(value).c_str(), nullptr), value);
  }
}

TEST(CountText, PutsASpaceEveryThreeDigits) {
  EXPECT_EQ(count_text(0), "0");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(1240), "1 240");
  EXPECT_EQ(count_text(100000), "100 000");
  EXPECT_EQ(count_text(1234567), "1 234 567");
  EXPECT_EQ(count_text(-123), "-123");
  EXPECT_EQ(count_text(-1234), "-1 234");
}

TEST(NumberText, RoundsToFixedDigits) {
  EXPECT_EQ(decimals(26.4385, 2), "26.44");
  EXPECT_EQ(decimals(3, 0), "3");
  EXPECT_EQ(decimals(-0.004, 2), "0.00");
  EXPECT_EQ(decimals(-0.006, 2), "-0.01");
}

TEST(NumberText, RoundsToSignificantDigits) {
  EXPECT_EQ(significant(3.2549e-7), "3.25e-07");
  EXPECT_EQ(significant(1234567.25, 8), "1234567.2");
  EXPECT_EQ(significant(0), "0");
}

}  // namespace
}  // namespace talus
