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

TEST(Quantity, RefusesWhatIsNone) {
  for (const char* text : {"", ".", "..", "P1", "P1.z", "P1.displacement", "P1.displacement.w", "P1.stress.x",
                           ".displacement.x", "displacement.x", "P1.displacement.", "P1..x"}) {
    EXPECT_FALSE(parse_quantity(text)) << text;
  }
}

}  // namespace
}  // namespace talus
