#include "model/time_table.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

const TimeTable pulse{{1, {0, 0, 0}}, {2, {4, 0, -8}}, {4, {0, 0, -8}}};

TEST(TimeTable, IsLinearBetweenRows) {
  EXPECT_EQ(value_at(pulse, 1), Vec3(0, 0, 0));
  EXPECT_EQ(value_at(pulse, 1.25), Vec3(1, 0, -2));
  EXPECT_EQ(value_at(pulse, 2), Vec3(4, 0, -8));
  EXPECT_EQ(value_at(pulse, 3), Vec3(2, 0, -8));
}

TEST(TimeTable, IsConstantBeforeTheFirstRowAndAfterTheLast) {
  EXPECT_EQ(value_at(pulse, 0), Vec3(0, 0, 0));
  EXPECT_EQ(value_at(pulse, 4), Vec3(0, 0, -8));
  EXPECT_EQ(value_at(pulse, 100), Vec3(0, 0, -8));
  EXPECT_EQ(value_at({{5, {1, 2, 3}}}, 0), Vec3(1, 2, 3));
}

}  // namespace
}  // namespace talus
