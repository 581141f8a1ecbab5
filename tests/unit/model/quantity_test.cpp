#include "model/quantity.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

TEST(Quantity, ReadsNameFieldAndComponent) {
  const auto quantity = parse_quantity("P1.displacement.z");
  ASSERT_TRUE(quantity);
  EXPECT_EQ(quantity->of, "P1");
  EXPECT_EQ(quantity->field, Quantity::Field::displacement);
  EXPECT_EQ(quantity->component, Quantity::Component::z);
}

TEST(Quantity, LetsNamesHoldDots) {
  const auto quantity = parse_quantity("slope.2.velocity.magnitude");
  ASSERT_TRUE(quantity);
  EXPECT_EQ(quantity->of, "slope.2");
  EXPECT_EQ(quantity->field, Quantity::Field::velocity);
  EXPECT_EQ(quantity->component, Quantity::Component::magnitude);
}

TEST(Quantity, ReadsStress) {
  const auto quantity = parse_quantity("P1.stress.zx");
  ASSERT_TRUE(quantity);
  EXPECT_EQ(quantity->of, "P1");
  EXPECT_EQ(quantity->field, Quantity::Field::stress);
  EXPECT_EQ(quantity->component, Quantity::Component::zx);
}

TEST(Quantity, HasAUnitAndAScale) {
  EXPECT_EQ(unit_of(Quantity::Field::displacement), "m");
  EXPECT_EQ(unit_of(Quantity::Field::velocity), "m/s");
  EXPECT_EQ(unit_of(Quantity::Field::stress), "Pa");
  EXPECT_EQ(similar(Quantity::Field::displacement, 4), 4);
  EXPECT_EQ(similar(Quantity::Field::velocity, 4), 2);
  EXPECT_EQ(similar(Quantity::Field::stress, 4), 4);
}

TEST(Quantity, RefusesWhatIsNone) {
  for (const char* text : {"", ".", "..", "P1", "P1.z", "P1.displacement", "P1.displacement.w", "P1.stress.x",
                           "P1.stress.magnitude", "P1.stress.zy", "P1.displacement.xx", "P1.velocity.zx",
                           ".displacement.x", "displacement.x", "P1.displacement.", "P1..x"}) {
    EXPECT_FALSE(parse_quantity(text)) << text;
  }
}

}  // namespace
}  // namespace talus
