#include "contact/broad/box_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace talus {
namespace {

Box random_box(std::mt19937& random) {
  std::uniform_real_distribution<double> place(0, 10), side(0, 1);
  Box box;
  const Vec3 lower(place(random), place(random), place(random));
  box.add(lower);
  box.add(Vec3(lower + Vec3(side(random), side(random), side(random))));
  return box;
}

TEST(BoxTree, KnowsOfAnItemWhetherAnotherOneOverlapsIt) {
  std::mt19937 random(7);
  std::vector<Box> boxes(200);
  for (Box& box : boxes) box = random_box(random);
  BoxTree tree;
  tree.build(boxes);
  std::vector<int> stack;
  int by_themselves = 0;
  for (int item = 0; item < 200; ++item) {
    bool any = false;
    for (int i = 0; i < 200; ++i) any = any || (i != item && boxes[i].within(boxes[item], 0));
    EXPECT_EQ(tree.any_other_within(item, boxes, stack), any) << item;
    by_themselves += any ? 0 : 1;
  }
  EXPECT_GT(by_themselves, 5);
  EXPECT_LT(by_themselves, 195);
}

TEST(BoxTree, FindsAllItemsNearABoxAsBoxesChangeOneByOne) {
  std::mt19937 random(5);
  std::vector<Box> boxes(200);
  for (Box& box : boxes) box = random_box(random);
  BoxTree tree;
  tree.build(boxes);
  std::vector<int> stack, found;
  std::uniform_int_distribution<int> any(0, 199);
  for (int change = 0; change < 300; ++change) {
    const int item = any(random);
    boxes[item] = random_box(random);
    tree.refit(item, boxes);
    const Box asked = random_box(random);
    found.clear();
    tree.within(asked, 0.4, boxes, stack, found);
    std::sort(found.begin(), found.end());
    std::vector<int> near;
    for (int i = 0; i < 200; ++i) {
      if (boxes[i].within(asked, 0.4)) near.push_back(i);
    }
    ASSERT_EQ(found, near) << change;
  }
}

TEST(BoxTree, ABoxIsAsFarFromAnotherAsTheAxisThatPartsThemSays) {
  Box a, b;
  a.add(Vec3(0, 0, 0));
  a.add(Vec3(1, 1, 1));
  b.add(Vec3(3, -1, 0.5));
  b.add(Vec3(4, -0.5, 2));
  EXPECT_EQ(a.apart(b), 2);
  EXPECT_EQ(b.apart(a), 2);
  b.widen(1.75);
  EXPECT_EQ(a.apart(b), 0.25);
  b.widen(0.5);
  EXPECT_EQ(a.apart(b), -0.25);
}

}  // namespace
}  // namespace talus
