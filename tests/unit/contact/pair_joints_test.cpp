#include "contact/pair_joints.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

TEST(PairJoints, AreTheUsualOneBetweenMostBodies) {
  PairJoints joints(3);
  EXPECT_EQ(joints.of(0, 1), 3);
  joints.set(7, 2, 1);
  joints.set(2, 9, 4);
  joints.set(9, 2, 5);
  EXPECT_EQ(joints.of(2, 7), 1);
  EXPECT_EQ(joints.of(7, 2), 1);
  EXPECT_EQ(joints.of(9, 2), 5) << "the last one said";
  EXPECT_EQ(joints.of(7, 9), 3);
}

}  // namespace
}  // namespace talus
