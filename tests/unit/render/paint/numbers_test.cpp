#include "render/paint/numbers.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace talus {
namespace {

const std::string thin = "\u2009", minus = "\u2212";

TEST(FormatNumber, KeepsThreeSignificantFigures) {
  EXPECT_EQ(format_number(0), "0");
  EXPECT_EQ(format_number(1.23456), "1.23");
  EXPECT_EQ(format_number(45), "45.0");
  EXPECT_EQ(format_number(0.0012345), "0.00123");
  EXPECT_EQ(format_number(999.6), "1000");
  EXPECT_EQ(format_number(1234.5), "1230");
  EXPECT_EQ(format_number(1234.5, 6), "1234.50");
}

TEST(FormatNumber, GroupsByThinSpacesFromTenThousandOn) {
  EXPECT_EQ(format_number(9990), "9990");
  EXPECT_EQ(format_number(12345), "12" + thin + "300");
  EXPECT_EQ(format_decimals(1234567.25, 1), "1" + thin + "234" + thin + "567.2");
}

TEST(FormatNumber, WritesTheTrueMinusAndNoMinusZero) {
  EXPECT_EQ(format_number(-2.5), minus + "2.50");
  EXPECT_EQ(format_decimals(-0.001, 1), "0.0");
}

TEST(FormatNumber, UsesPowersOfTenOutsideTheReadableRange) {
  EXPECT_EQ(format_number(2.5e7), "2.50\u00d710\u2077");
  EXPECT_EQ(format_number(-1.234e-5), minus + "1.23\u00d710\u207b\u2075");
  EXPECT_EQ(format_number(9.999e6), "1.00\u00d710\u2077");
  EXPECT_EQ(format_number(1.5e-12), "1.50\u00d710\u207b\u00b9\u00b2");
}

TEST(FormatNumber, ShowsADashForWhatIsNotFinite) {
  EXPECT_EQ(format_number(std::numeric_limits<double>::quiet_NaN()), "\u2013");
  EXPECT_EQ(format_decimals(std::numeric_limits<double>::infinity(), 2), "\u2013");
}

TEST(NiceTicks, AreMultiplesOfOneTwoOrFive) {
  EXPECT_EQ(nice_ticks(0, 20, 6), (std::vector<double>{0, 5, 10, 15, 20}));
  EXPECT_EQ(nice_ticks(0, 100, 11), (std::vector<double>{0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100}));
  EXPECT_EQ(nice_ticks(-3.1, 4.2, 5), (std::vector<double>{-2, 0, 2, 4}));
  const std::vector<double> small = nice_ticks(0, 0.3, 4);
  ASSERT_EQ(small.size(), 4u);
  EXPECT_NEAR(small[3], 0.3, 1e-12);
}

TEST(NiceTicks, AreNeverMoreThanAskedForNorFewerThanTwo) {
  for (const double high : {1.0, 1.7, 2.3, 4.9, 7.7, 9.99, 123.0, 6.1e9, 3e-7})
    for (int most = 2; most <= 11; ++most) {
      const std::vector<double> ticks = nice_ticks(0, high, most);
      EXPECT_LE(ticks.size(), static_cast<std::size_t>(most)) << high;
      EXPECT_GE(ticks.size(), most == 2 ? 1u : 2u) << high << ' ' << most;
      EXPECT_LE(ticks.back(), high * (1 + 1e-9));
    }
}

TEST(TickLabels, ShareTheirDecimals) {
  EXPECT_EQ(tick_labels({-0.5, 0, 0.5}), (std::vector<std::string>{minus + "0.5", "0.0", "0.5"}));
  EXPECT_EQ(tick_labels({0, 10000, 20000}), (std::vector<std::string>{"0", "10" + thin + "000", "20" + thin + "000"}));
  EXPECT_EQ(tick_labels({0, 0.05, 0.1}), (std::vector<std::string>{"0.00", "0.05", "0.10"}));
}

TEST(RoundNumbers, EndScalesAndBars) {
  EXPECT_DOUBLE_EQ(round_up(16.3), 20);
  EXPECT_DOUBLE_EQ(round_up(0.0121), 0.015);
  EXPECT_DOUBLE_EQ(round_up(5), 5);
  EXPECT_DOUBLE_EQ(round_up(8.1e6), 1e7);
  EXPECT_DOUBLE_EQ(round_down(49), 20);
  EXPECT_DOUBLE_EQ(round_down(0.5), 0.5);
  EXPECT_DOUBLE_EQ(round_down(1000), 1000);
}

TEST(DisplayUnit, ChoosesThePrefixByMagnitude) {
  EXPECT_EQ(display_unit("Pa", 3e6).name, "MPa");
  EXPECT_DOUBLE_EQ(display_unit("Pa", 3e6).factor, 1e-6);
  EXPECT_EQ(display_unit("Pa", -2e4).name, "kPa");
  EXPECT_EQ(display_unit("Pa", 5e10).name, "GPa");
  EXPECT_EQ(display_unit("N", 999).name, "N");
  EXPECT_EQ(display_unit("N", 1000).name, "kN");
  EXPECT_EQ(display_unit("J", -3e9).name, "GJ");
  EXPECT_EQ(display_unit("m", 0.004).name, "mm");
  EXPECT_EQ(display_unit("m/s", 2e-6).name, "\u00b5m/s");
  EXPECT_EQ(display_unit("m", 45).name, "m");
  EXPECT_EQ(display_unit("m", 0).name, "m");
}

}  // namespace
}  // namespace talus
