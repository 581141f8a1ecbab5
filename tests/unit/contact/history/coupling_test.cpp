#include "contact/history/coupling.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/contact/blocks.hpp"

/// Which nodes the plan of the matrix couples.
namespace talus {
namespace {

using testing::box;
using testing::reach;
using testing::Scene;

/// A slab, a block on it and a block on that, of which some are single bodies.
Scene coupled_tower(bool lower_is_single, bool upper_is_single) {
  Scene scene;
  scene.add(box({0, 0, -1}, {3, 3, 0}, {4, 4, 1}), true);
  scene.single_body = lower_is_single;
  scene.add(box({1, 1, 0}, {2, 2, 1}, {3, 3, 3}));
  scene.single_body = upper_is_single;
  scene.add(box({1, 1, 1}, {2, 2, 2}, {2, 2, 2}));
  return scene;
}

using Pairs = std::vector<std::pair<int, int>>;

TEST(Coupling, ASingleBodyHasOneHandle) {
  Scene scene = coupled_tower(true, true);
  scene.detect(reach);
  EXPECT_EQ(scene.detector().coupled_nodes(), (Pairs{{scene.first_node(1), scene.first_node(2)}}));
}

TEST(Coupling, HandlesAreCoupledWithTheNodesOfDeformableBodies) {
  Scene scene = coupled_tower(true, false);
  scene.detect(reach);
  const Pairs& pairs = scene.detector().coupled_nodes();
  ASSERT_FALSE(pairs.empty());
  int with_handle = 0;
  for (const auto& [i, j] : pairs) {
    EXPECT_TRUE(i == scene.first_node(1) || i >= scene.first_node(2));
    EXPECT_GE(j, scene.first_node(2));
    with_handle += i == scene.first_node(1);
  }
  EXPECT_EQ(with_handle, 9);  // the nodes of the upper one's lower face
}

TEST(Coupling, BodiesThatHavePartedAreNoLongerPlannedTogether) {
  Scene scene = coupled_tower(true, true);
  scene.detect(reach);
  ASSERT_EQ(scene.detector().coupled_nodes().size(), 1u);
  const std::uint64_t generation = scene.detector().coupling_generation();
  scene.move(2, {0, 0, 0.5});
  int steps = 0;
  while (scene.detector().coupling_generation() == generation && steps < 100) {
    scene.detect(reach);
    ++steps;
  }
  EXPECT_TRUE(scene.detector().coupled_nodes().empty());
  EXPECT_GT(steps, 10) << "a bounce would change the plan twice";
  scene.move(2, {0, 0, -0.5});
  scene.detect(reach);
  EXPECT_EQ(scene.detector().coupled_nodes().size(), 1u);
}

TEST(Coupling, ASingleBodyThatSlidesChangesNothing) {
  Scene scene = coupled_tower(true, true);
  scene.detect(reach);
  const std::uint64_t generation = scene.detector().coupling_generation();
  for (int step = 0; step < 20; ++step) {
    scene.move(2, {0.03, 0.02, 0});
    scene.detect(reach);
    EXPECT_EQ(scene.detector().coupling_generation(), generation);
  }
}

TEST(Coupling, SleepersAreLeftOutAndComeBack) {
  Scene scene = coupled_tower(false, false);
  scene.detect(reach);
  const Pairs all = scene.detector().coupled_nodes();
  const std::uint64_t generation = scene.detector().coupling_generation();
  scene.detector().set_asleep({0, 1, 0});
  EXPECT_GT(scene.detector().coupling_generation(), generation);
  Pairs left = all;
  std::erase_if(left, [&](const auto& pair) { return pair.first < scene.first_node(2); });
  EXPECT_EQ(scene.detector().coupled_nodes(), left);
  scene.detector().set_asleep({0, 0, 0});
  scene.detect(reach);
  EXPECT_EQ(scene.detector().coupled_nodes(), all);
}

}  // namespace
}  // namespace talus
