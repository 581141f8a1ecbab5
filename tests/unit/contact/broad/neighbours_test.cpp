#include "contact/broad/neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "unit/contact/blocks.hpp"

namespace talus {
namespace {

using testing::box;
using testing::Scene;

constexpr int count = 60;

/// Unit cubes here and there in a box, and what knows of their motion.
struct Swarm {
  Swarm() {
    std::uniform_real_distribution<double> place(0, 20);
    for (int b = 0; b < count; ++b) {
      const Vec3 lower(place(random), place(random), place(random));
      scene.add(box(lower, lower + Vec3(1, 1, 1)));
    }
    features = std::make_unique<ContactFeatures>(scene.bodies());
    facets = std::make_unique<FaceBoxes>(*features, odometers);
    for (int b = 0; b < count; ++b) set(b, false);
  }
  void set(int body, bool rests) {
    resting[body] = rests;
    neighbours.set(body, {0.3, 1, rests});
  }
  void move(int body, const Vec3& by) {
    scene.move(body, by);
    odometers.add(body, by.norm());
  }
  bool follow(double reach) {
    const bool changed = neighbours.follow(scene.x, reach, odometers, *facets);
    odometers.have_seen();
    return changed;
  }
  double apart(int a, int b) const {
    std::array<Box, 2> boxes;
    for (int k = 0; k < 2; ++k) {
      const int body = k ? b : a, first = scene.first_node(body);
      for (int i = first; i < first + scene.node_count(body); ++i) boxes[k].add(scene.x[i]);
    }
    return boxes[0].apart(boxes[1]);
  }
  bool listed(int a, int b) const {
    return std::binary_search(neighbours.pairs().begin(), neighbours.pairs().end(), std::pair(a, b));
  }

  std::mt19937 random{9};
  Scene scene;
  std::unique_ptr<ContactFeatures> features;
  Odometers odometers{count};
  std::unique_ptr<FaceBoxes> facets;
  Neighbours neighbours{count};
  std::array<bool, count> resting{};
};

TEST(Neighbours, AreAllThatMayBeWithinTheSearchDistanceAndNoneAtRest) {
  Swarm swarm;
  std::normal_distribution<double> displacement(0, 0.1);
  std::uniform_int_distribution<int> any(0, count - 1);
  for (int step = 0; step < 300; ++step) {
    const double reach = step % 100 < 50 ? 1e-3 : 1.5;
    const int turned = any(swarm.random);
    swarm.set(turned, !swarm.resting[turned]);
    for (int b = 0; b < count; ++b) {
      if (!swarm.resting[b])
        swarm.move(b, {displacement(swarm.random), displacement(swarm.random), displacement(swarm.random)});
    }
    swarm.follow(reach);
    ASSERT_TRUE(std::is_sorted(swarm.neighbours.pairs().begin(), swarm.neighbours.pairs().end()));
    for (int a = 0; a < count; ++a) {
      for (int b = a + 1; b < count; ++b) {
        if (swarm.resting[a] && swarm.resting[b]) {
          EXPECT_FALSE(swarm.listed(a, b)) << step;
        } else if (swarm.apart(a, b) <= std::max(reach, 0.3)) {
          EXPECT_TRUE(swarm.listed(a, b)) << step;
        }
      }
    }
  }
}

TEST(Neighbours, AreFoundAsFarAsEachBodyReaches) {
  Swarm swarm;
  Reach reach(0.01);
  reach.multiple = 2.5;
  reach.ways.assign(count, {});
  reach.ways[7] = {Vec3(1.2, 0, 0), 0.3};
  ASSERT_TRUE(swarm.neighbours.follow(swarm.scene.x, reach, swarm.odometers, *swarm.facets));
  int far = 0;
  for (int b = 0; b < count; ++b) {
    const int low = std::min(b, 7), high = std::max(b, 7);
    if (b == 7 || swarm.apart(low, high) > reach(low, high)) continue;
    EXPECT_TRUE(swarm.listed(low, high)) << b;
    far += swarm.apart(low, high) > 2;
  }
  EXPECT_GT(far, 0) << "those 3.75 m away";
  EXPECT_LT(swarm.neighbours.pairs().size(), count * 10u) << "what the others reach is their own";
}

TEST(Neighbours, AreSoughtOnlyWhenABodyLeavesItsBox) {
  Swarm swarm;
  EXPECT_TRUE(swarm.follow(1e-3));
  EXPECT_FALSE(swarm.follow(1e-3));
  int changes = 0;
  for (int step = 0; step < 330; ++step) {
    swarm.move(7, {0.01, 0, 0});
    changes += swarm.follow(1e-3);
  }
  EXPECT_GE(changes, 8);  // 0.1 in the first box, then 32 steps in each
  EXPECT_LE(changes, 12);
}

}  // namespace
}  // namespace talus
