#include "solve/dynamics/sweep_layers.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

namespace talus {
namespace {

/// A wall of bodies side by side, four contacts between any two of them and one a body with what carries it.
std::vector<SweepLayers::Pair> wall(int length, int height) {
  std::vector<SweepLayers::Pair> pairs;
  const auto body = [&](int i, int k) { return i * height + k; };
  for (int i = 0; i < length; ++i)
    for (int k = 0; k < height; ++k) {
      pairs.push_back({-1, body(i, k)});
      if (i > 0) pairs.insert(pairs.end(), 4, {body(i - 1, k), body(i, k)});
      if (k > 0) pairs.insert(pairs.end(), 4, {body(i, k), body(i, k - 1)});
    }
  return pairs;
}

TEST(SweepLayers, WhatIsSweptOverAtOnceTouchesNoBodyTwice) {
  const auto pairs = wall(40, 10);
  SweepLayers layers;
  const std::vector<int> layer = layers.of(pairs, 400);
  const int count = *std::ranges::max_element(layer) + 1;
  EXPECT_GT(count, 4);
  EXPECT_LE(count, 8) << "layers that are thin carry a push less far";
  std::vector<std::set<int>> touched(count);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (const int body : pairs[i])
      if (body >= 0) touched[layer[i]].insert(body);
  for (int a = 0; a < count; ++a)
    for (int b = a + 2; b < count; b += 2)
      for (const int body : touched[a]) EXPECT_FALSE(touched[b].contains(body)) << a << ", " << b;
}

TEST(SweepLayers, FewContactsAreNotDivided) { EXPECT_THAT(SweepLayers().of(wall(4, 4), 16), testing::Each(0)); }

TEST(SweepLayers, NothingIsLeftOfOtherContacts) {
  SweepLayers used, fresh;
  used.of(wall(60, 5), 300);
  EXPECT_EQ(used.of(wall(20, 20), 400), fresh.of(wall(20, 20), 400));
}

}  // namespace
}  // namespace talus
