#include "base/quantity_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "base/error.hpp"

namespace talus {
namespace {

using testing::HasSubstr;

struct Typed {
  const char *text, *kept;
  double value;
};

std::ostream& operator<<(std::ostream& out, const Typed& typed) { return out << typed.text << " for " << typed.kept; }

class QuantityText : public testing::TestWithParam<Typed> {};

TEST_P(QuantityText, IsUnderstoodToTheLastDigit) {
  EXPECT_EQ(read_quantity(GetParam().text, GetParam().kept, GetParam().kept), GetParam().value);
}

INSTANTIATE_TEST_SUITE_P(
    Units, QuantityText,
    testing::Values(Typed{"50 kPa", "Pa", 50000}, Typed{"50kPa", "Pa", 50000}, Typed{"25 GPa", "Pa", 25e9},
                    Typed{"2.7 t/m³", "kg/m³", 2700}, Typed{"2,7 t/m3", "kg/m³", 2700},
                    Typed{"2.7 g/cm^3", "kg/m³", 2700}, Typed{"30°", "°", 30}, Typed{"30 deg", "°", 30},
                    Typed{"12 mm", "m", 0.012}, Typed{"3 min", "s", 180}, Typed{"1.5 h", "s", 5400},
                    Typed{"200 ms", "s", 0.2}, Typed{"1 ft", "m", 0.3048}, Typed{"36 km/h", "m/s", 10},
                    Typed{"2 GPa/m", "Pa/m", 2e9}, Typed{"3 kN/m³", "Pa/m", 3000}, Typed{"50 Hz", "1/s", 50},
                    Typed{"0.5 1/s", "1/s", 0.5}, Typed{"1 250 000 Pa", "Pa", 1250000}, Typed{"5 %", "", 0.05},
                    Typed{"−3", "m", -3}, Typed{"12\u2009000", "m", 12000}, Typed{"+1e6", "Pa", 1e6},
                    Typed{" 9.81 m s-2 ", "m/s²", 9.81}, Typed{"1 MN", "N", 1e6}, Typed{"0.5 m²/m³", "m²/m³", 0.5},
                    Typed{"2 1/m", "m²/m³", 2}, Typed{"5 cm2/dm3", "m²/m³", 0.5}));

TEST(QuantityText, OfADensityMayBeTheWeight) {
  EXPECT_NEAR(read_quantity("25.506 kN/m3", "kg/m³", "kg/m³"), 2600, 1e-9);
}

TEST(QuantityText, OfAnAngleMayBeInRadians) {
  EXPECT_NEAR(read_quantity("0.5 rad", "°", "°"), 90 / std::numbers::pi, 1e-13);
  EXPECT_NEAR(read_quantity("180 °/s", "rad/s", "rad/s"), std::numbers::pi, 1e-14);
}

TEST(QuantityText, ANumberAloneIsInTheUnitThatIsShown) {
  EXPECT_EQ(read_quantity("0.2", "Pa", "MPa"), 200000);
  EXPECT_EQ(read_quantity("0.2 kPa", "Pa", "MPa"), 200);
}

TEST(QuantityText, OfAnotherKindSaysWhatIsWanted) {
  try {
    read_quantity("5 kPa", "m", "m");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(), "'kPa' is a stress, and a length is wanted here");
    EXPECT_THAT(error.remedy(), HasSubstr("mm"));
  }
  EXPECT_THROW(read_quantity("5 s", "m/s", "m/s"), InputError);
  EXPECT_THROW(read_quantity("5 m/s", "s", "s"), InputError) << "no weight of a time";
  EXPECT_THROW(read_quantity("5 m", "", ""), InputError);
}

TEST(QuantityText, ThatIsNoneSaysSo) {
  for (const char* text : {"", "abc", "kPa", "nan", "inf", "--3", "5 furlongs", "5 m//s", "5 /", "1e400"})
    EXPECT_THROW(read_quantity(text, "m", "m"), InputError) << text;
}

TEST(QuantityText, IsConvertedBothWays) {
  EXPECT_EQ(converted(200000, "Pa", "MPa"), 0.2);
  EXPECT_EQ(converted(0.012, "m", "mm"), 12);
  EXPECT_NEAR(converted(2600, "kg/m³", "kN/m³"), 25.506, 1e-12);
  EXPECT_EQ(converted(3, "", ""), 3);
  EXPECT_THROW(converted(1, "m", "s"), InputError);
}

}  // namespace
}  // namespace talus
