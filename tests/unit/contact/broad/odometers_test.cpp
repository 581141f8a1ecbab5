#include "contact/broad/odometers.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace talus {
namespace {

TEST(Odometers, SumTheDisplacementsAndNameWhatMoved) {
  Odometers odometers(3);
  odometers.add(1, 0.5);
  odometers.add(1, 0.25);
  odometers.add(2, 1);
  EXPECT_EQ(odometers.moved().size(), 2u);
  EXPECT_GE(odometers.travelled(1), 0.75);
  EXPECT_NEAR(odometers.travelled(1), 0.75, 1e-15);
  EXPECT_EQ(odometers.pace(1), 0.25);
  EXPECT_EQ(odometers.moves(1), 2u);
  EXPECT_EQ(odometers.moves(0), 0u);
  odometers.have_seen();
  EXPECT_TRUE(odometers.moved().empty());
  EXPECT_NEAR(odometers.travelled(2), 1, 1e-15);
}

TEST(Odometers, ASmallDisplacementOnTopOfALargeOneStillCounts) {
  Odometers odometers(1);
  odometers.add(0, 1e6);
  const double before = odometers.travelled(0);
  odometers.add(0, 1e-20);
  EXPECT_GT(odometers.travelled(0), before);
  EXPECT_EQ(odometers.moves(0), 2u);
}

TEST(Odometers, ReadTheLargestDisplacementAlongAnAxisOffTheNodes) {
  Odometers odometers(2);
  std::vector<Vec3> x = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)};
  const auto read = [&] {
    odometers.read(0, 0, 2, x);
    odometers.read(1, 2, 2, x);
  };
  read();
  EXPECT_TRUE(odometers.moved().empty());
  x[2] += Vec3(0.1, -0.3, 0);
  x[3] += Vec3(0.2, 0, 0);
  read();
  ASSERT_EQ(odometers.moved().size(), 1u);
  EXPECT_EQ(odometers.moved()[0], 1);
  EXPECT_NEAR(odometers.travelled(1), 0.3, 1e-15);
  read();
  EXPECT_EQ(odometers.moves(1), 1u);
  EXPECT_EQ(odometers.pace(1), 0);
}

TEST(Odometers, WhatIsNoNumberIsFartherThanAnyMargin) {
  Odometers odometers(1);
  odometers.add(0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_GT(odometers.travelled(0), 1e100);
  EXPECT_TRUE(std::isfinite(odometers.travelled(0)));
}

}  // namespace
}  // namespace talus
