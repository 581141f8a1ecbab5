#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "unit/contact/blocks.hpp"

/// Bodies that a stage holds or releases.
namespace talus {
namespace {

using testing::box;
using testing::reach;
using testing::Scene;
using testing::total_area;

/// Slab, block and a block on top of it, bonded.
Scene held_tower(bool lower_fixed, bool upper_fixed) {
  Scene scene;
  scene.laws = {{.friction = 0.6, .residual_friction = 0.2, .cohesion = 2e5}};
  scene.add(box({0, 0, -1}, {3, 3, 0}, {4, 4, 1}), true);
  scene.add(box({1, 1, 0}, {2, 2, 1}, {3, 3, 3}), lower_fixed);
  scene.add(box({1, 1, 1}, {2, 2, 2}, {2, 2, 2}), upper_fixed);
  return scene;
}

void accept(Scene& scene, const Vec3& traction) {
  std::vector<ContactOutcome> outcomes(scene.contacts.points.size());
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    ContactPoint& p = scene.contacts.points[i];
    p.mode = ContactMode::stick;
    outcomes[i].gap = p.gap;
    outcomes[i].shear_force = p.area * traction;
  }
  scene.detector().accept(scene.contacts, outcomes);
}

double area_between(const ContactSet& contacts, int a, int b) {
  double area = 0;
  for (const ContactPoint& p : contacts.points) area += p.bodies[0] == a && p.bodies[1] == b ? p.area : 0;
  return area;
}

TEST(Held, TwoHeldBodiesMakeNoContactUntilOneIsReleased) {
  Scene scene = held_tower(false, false);
  EXPECT_NEAR(total_area(scene.detect(reach)), 2, 1e-12);
  scene.detector().set_fixed({true, true, false});
  EXPECT_NEAR(area_between(scene.detect(reach), 1, 2), 1, 1e-12);
  EXPECT_NEAR(total_area(scene.contacts), 1, 1e-12);
  scene.detector().set_fixed({true, false, false});
  EXPECT_NEAR(total_area(scene.detect(reach)), 2, 1e-12);
}

TEST(Held, AHeldBodyIsNotMeasuredAgainst) {
  Scene scene = held_tower(false, false);
  const auto stiffness = [&] {
    double sum = 0;
    for (const ContactPoint& p : scene.detect(reach).points) sum += p.bodies[0] == 1 ? p.normal_stiffness : 0;
    return sum;
  };
  EXPECT_NEAR(stiffness(), 10 * 0.5e9 / scene.size(1), 1);
  scene.detector().set_fixed({true, true, false});
  EXPECT_NEAR(stiffness(), 10 * 1e9 / scene.size(2), 1);
}

TEST(Held, OnlyMovableNodesAreCoupled) {
  Scene scene = held_tower(false, false);
  scene.detect(reach);
  const std::uint64_t generation = scene.detector().coupling_generation();
  scene.detector().set_fixed({true, true, false});
  scene.detect(reach);
  EXPECT_GT(scene.detector().coupling_generation(), generation);
  for (const auto& [i, j] : scene.detector().coupled_nodes()) EXPECT_GE(std::min(i, j), scene.first_node(2));
  scene.detector().set_fixed({true, false, false});
  scene.detect(reach);
  const auto& pairs = scene.detector().coupled_nodes();
  EXPECT_TRUE(std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
    return pair.first < scene.first_node(2) && pair.second >= scene.first_node(2);
  }));
}

TEST(Held, ContactsOfHeldBodiesAreRemembered) {
  Scene scene = held_tower(false, false);
  scene.detect(reach);
  accept(scene, {5, 0, 0});
  scene.detector().set_fixed({true, true, true});
  for (int step = 0; step < 3; ++step) {
    EXPECT_TRUE(scene.detect(reach).points.empty());
    accept(scene, {0, 0, 0});
  }
  scene.detector().set_fixed({true, false, false});
  scene.detect(reach);
  EXPECT_NEAR(total_area(scene.contacts), 2, 1e-12);
  for (const ContactPoint& p : scene.contacts.points) {
    EXPECT_TRUE(p.bonded);
    EXPECT_LT((p.shear_start - Vec3(5 * p.area, 0, 0)).norm(), 1e-12);
  }
}

TEST(Held, BodiesReleasedForTheFirstTimeAreBondedThen) {
  Scene scene = held_tower(true, true);
  EXPECT_TRUE(scene.detect(reach).points.empty());
  accept(scene, {0, 0, 0});
  scene.detector().set_fixed({true, true, false});
  for (const ContactPoint& p : scene.detect(reach).points) EXPECT_TRUE(p.bonded);
  EXPECT_NEAR(total_area(scene.contacts), 1, 1e-12);
  // The lower one is released later: its joint with the slab is bonded, what became loose above is not bonded again.
  accept(scene, {0, 0, 0});
  scene.move(2, {0, 0, 0.5});
  scene.detect(reach);
  accept(scene, {0, 0, 0});
  scene.move(2, {0, 0, -0.5});
  scene.detector().set_fixed({true, false, false});
  for (const ContactPoint& p : scene.detect(reach).points) EXPECT_EQ(p.bonded, p.bodies[0] == 0);
  EXPECT_NEAR(total_area(scene.contacts), 2, 1e-12);
}

TEST(Held, EveryBodyNeedsAnEntry) {
  Scene scene = held_tower(false, false);
  EXPECT_THROW(scene.detector().set_fixed({true}), std::logic_error);
}

}  // namespace
}  // namespace talus
