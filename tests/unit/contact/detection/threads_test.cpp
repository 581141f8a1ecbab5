#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>

#include "base/parallel.hpp"
#include "unit/contact/blocks.hpp"

namespace talus {
namespace {

using testing::box;
using testing::Scene;

/// Cubes of 48 triangles on each other and beside each other on a slab, no two turned alike: faces, vertices, edges and
/// corners touch.
Scene pile(ContactModel model) {
  Scene scene;
  scene.settings.model = model;
  scene.laws[0].cohesion = 1e5;
  scene.add(box({-1, -1, -1}, {4, 4, 0}, {4, 4, 1}), true);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> tilt(-2e-3, 2e-3);
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        const Vec3 lower(i, j, k), axis(tilt(random), tilt(random), tilt(random));
        const int body = scene.add(box(lower, lower + Vec3(1, 1, 1), {2, 2, 2}, (i + j + k) % 2));
        for (int n = 0; n < scene.node_count(body); ++n) {
          Vec3& x = scene.x[scene.first_node(body) + n];
          x += axis.cross(x - lower);
        }
      }
  return scene;
}

void tremble(Scene& scene, int step) {
  std::mt19937 random(step);
  std::uniform_real_distribution<double> way(-1e-3, 1e-3);
  for (int b = 1; b < static_cast<int>(scene.bodies().size()); ++b)
    scene.move(b, {way(random), way(random), way(random)});
}

/// All numbers that detection hands out in steps of a pile that trembles, and what is missed on the way.
struct Seen {
  std::vector<std::uint64_t> bits;
  std::vector<double> missed;
  long facet_pairs = 0;  // a step

  void add(double number) { bits.push_back(std::bit_cast<std::uint64_t>(number)); }
  void add(const Vec3& v) {
    for (const double number : v) add(number);
  }
  void add(const ContactSet& contacts) {
    for (const ContactPoint& p : contacts.points) {
      bits.push_back(p.key);
      for (const Vec3& v : {p.position, p.normal, p.shear_start}) add(v);
      for (const double number : {p.gap, p.initial_interference, p.area, p.normal_stiffness, p.cohesion, p.multiplier})
        add(number);
    }
    for (const int node : contacts.nodes) bits.push_back(node);
    for (const double weight : contacts.weights) add(weight);
  }
};

Seen look(ContactModel model, int threads) {
  const ThreadLimit limit(threads);
  Scene scene = pile(model);
  Seen seen;
  Reach ahead = testing::reach;
  ahead.ways.assign(scene.bodies().size(), {Vec3::Zero(), 1.0});
  constexpr int steps = 8;
  for (int step = 0; step < steps; ++step) {
    const std::vector<Vec3> start = scene.x;
    seen.add(scene.detect(testing::reach));
    tremble(scene, step);
    for (const auto& missed : scene.detector().missed_contacts(start, scene.x, ahead, 1e-5)) {
      seen.add(missed.position);
      seen.missed.push_back(missed.depth);
    }
    accept_as_stuck(scene);
  }
  seen.facet_pairs = scene.detector().work().facet_pairs / steps;
  return seen;
}

class Threads : public ::testing::TestWithParam<ContactModel> {};

TEST_P(Threads, SeeTheSameBitsHoweverManyTheyAre) {
  const Seen one = look(GetParam(), 1);
  ASSERT_GT(one.facet_pairs, 10'000) << "too few to be worth a second thread";
  ASSERT_GT(one.bits.size(), 10'000U);
  if (GetParam() == ContactModel::area) {
    ASSERT_FALSE(one.missed.empty());
  }
  for (const int threads : {2, 3}) {
    const Seen several = look(GetParam(), threads);
    EXPECT_TRUE(several.bits == one.bits) << threads;
    EXPECT_TRUE(several.missed == one.missed) << threads;
  }
}

INSTANTIATE_TEST_SUITE_P(Contact, Threads, ::testing::Values(ContactModel::area, ContactModel::facet_wise));

}  // namespace
}  // namespace talus
