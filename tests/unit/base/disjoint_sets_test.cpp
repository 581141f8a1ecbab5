#include "base/disjoint_sets.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

TEST(DisjointSets, WhatIsJoinedThroughOthersBelongsTogetherAndGoesByItsLowestNumber) {
  DisjointSets sets;
  sets.reset(6);
  EXPECT_EQ(sets.first_of(5), 5);
  sets.join(4, 2);
  sets.join(5, 4);
  sets.join(0, 3);
  EXPECT_EQ(sets.first_of(5), 2);
  EXPECT_EQ(sets.first_of(3), 0);
  EXPECT_EQ(sets.first_of(1), 1);
  sets.join(5, 3);
  EXPECT_EQ(sets.first_of(2), 0);
  sets.reset(3);
  EXPECT_EQ(sets.size(), 3);
  EXPECT_EQ(sets.first_of(2), 2);
}

}  // namespace
}  // namespace talus
