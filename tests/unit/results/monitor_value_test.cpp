#include "results/monitor_value.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace talus {
namespace {

MonitorSample sample() {
  Voigt stress;
  stress << 1, 2, 3, 4, 5, 6;
  return {Vec3(2, 3, 6), Vec3(-1, 4, 8), stress};
}

double value(const char* text, const MonitorSample& sample) {
  const Quantity quantity = *parse_quantity(text);
  return component_of(field_value(sample, quantity.field), quantity.component);
}

TEST(MonitorValue, IsTheComponentThatTheQuantityNames) {
  EXPECT_EQ(value("P.displacement.x", sample()), 2);
  EXPECT_EQ(value("P.displacement.z", sample()), 6);
  EXPECT_EQ(value("P.velocity.y", sample()), 4);
  EXPECT_EQ(value("P.stress.xx", sample()), 1);
  EXPECT_EQ(value("P.stress.xy", sample()), 4);
  EXPECT_EQ(value("P.stress.zx", sample()), 6);
}

TEST(MonitorValue, HasAMagnitude) {
  EXPECT_EQ(value("P.displacement.magnitude", sample()), 7);
  EXPECT_EQ(value("P.velocity.magnitude", sample()), 9);
}

TEST(MonitorValue, AStressThatWasNotRecordedIsNoNumber) {
  EXPECT_TRUE(std::isnan(value("P.stress.zz", {Vec3(2, 3, 6), Vec3(-1, 4, 8)})));
}

}  // namespace
}  // namespace talus
