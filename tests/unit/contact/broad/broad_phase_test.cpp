#include "contact/broad/broad_phase.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "unit/contact/blocks.hpp"

/// What is found follows from the positions alone, to the bit; what is looked at follows motion.
namespace talus {
namespace {

using testing::box;
using testing::mapped;
using testing::Scene;

/// Cubes of several sizes on a slab and over it, n³ of them, `apart` from each other.
Scene heap(int n, double apart, const Vec3& at = Vec3::Zero()) {
  Scene scene;
  const double side = n * (1 + apart);
  scene.add(mapped(box({-1, -1, -1}, {side, side, 0}, {3, 4, 1}), [&](const Vec3& p) { return Vec3(p + at); }), true);
  for (int i = 0; i < n * n * n; ++i) {
    const Vec3 lower = at + (1 + apart) * Vec3(i % n, i / n % n, i / n / n);
    const int cells = 1 + i % 3;
    scene.add(box(lower, lower + (0.7 + 0.1 * (i % 4)) * Vec3(1, 1, 1), {cells, cells, cells}));
  }
  return scene;
}

/// Every pair of faces of bodies of which one is `awake`, asked one by one.
std::vector<FacePair> all_near(const BroadPhase& broad, const ContactFeatures& features, std::span<const Vec3> x,
                               double reach, const std::vector<char>& awake) {
  std::vector<Box> boxes(features.faces.size());
  for (std::size_t f = 0; f < boxes.size(); ++f) {
    for (int node : features.outline(f)) boxes[f].add(x[node]);
  }
  std::vector<FacePair> pairs;
  const int bodies = static_cast<int>(awake.size());
  for (int a = 0; a < bodies; ++a) {
    for (int b = a + 1; b < bodies; ++b) {
      if (!awake[a] && !awake[b]) continue;
      const double distance = broad.search_distance(a, b, reach);
      for (int f = features.face_begin[a]; f < features.face_begin[a + 1]; ++f) {
        for (int g = features.face_begin[b]; g < features.face_begin[b + 1]; ++g) {
          if (boxes[f].within(boxes[g], distance)) pairs.push_back({f, g});
        }
      }
    }
  }
  return pairs;
}

void expect_same(std::span<const FacePair> found, std::span<const FacePair> all, int step) {
  const auto same = [](const FacePair& p, const FacePair& q) { return p.a == q.a && p.b == q.b; };
  ASSERT_EQ(found.size(), all.size()) << step;
  EXPECT_TRUE(std::equal(found.begin(), found.end(), all.begin(), same)) << step;
}

Vec3 random_vector(std::mt19937& random, double length) {
  std::uniform_real_distribution<double> unit(-length, length);
  return {unit(random), unit(random), unit(random)};
}

/// Moves a body, turns it and deforms it; the largest displacement of its nodes.
double disturb(Scene& scene, int body, double length, std::mt19937& random) {
  const Vec3 shift = random_vector(random, length), turn = random_vector(random, length);
  const int first = scene.first_node(body);
  const Vec3 origin = scene.x[first];
  double displacement = 0;
  for (int i = first; i < first + scene.node_count(body); ++i) {
    const Vec3 by = shift + turn.cross(scene.x[i] - origin) + random_vector(random, 0.1 * length);
    scene.x[i] += by;
    displacement = std::max(displacement, by.norm());
  }
  return displacement;
}

struct Trial {
  double apart, far;  // between the cubes; of all from the origin
  bool told;
};

class AnyMotion : public ::testing::TestWithParam<Trial> {};

TEST_P(AnyMotion, FindsWhatIsNearToTheBit) {
  const Trial trial = GetParam();
  Scene scene = heap(3, trial.apart, trial.far * Vec3(1, -1, 0.5));
  const ContactFeatures features(scene.bodies());
  ContactWork work;
  BroadPhase broad(features, scene.bodies(), scene.settings, work);
  std::mt19937 random(7);
  std::vector<char> awake(scene.bodies().size(), 1);
  awake[0] = 0;
  std::size_t found = 0;
  for (int step = 0; step < 150; ++step) {
    for (int b = 0; b < static_cast<int>(awake.size()); ++b) {
      // Some stay where they are, most creep, some fly; in the end the slab shakes.
      const double length = b % 4 == 0 ? 0 : b % 7 == 1 ? 0.06 : 3e-4;
      if (length == 0 && !(b == 0 && step > 120)) continue;
      const double displacement = disturb(scene, b, b == 0 ? 0.01 : length, random);
      if (trial.told) broad.moved(b, displacement);
    }
    if (!trial.told) broad.read_motion(scene.x);
    const double reach = step % 40 == 39 ? 0.5 : step % 3 == 0 ? 1e-3 : 0.02;
    const auto near = broad.find(scene.x, reach);
    found += near.size();
    expect_same(near, all_near(broad, features, scene.x, reach, awake), step);
  }
  EXPECT_GT(found, 1000u);
}

TEST(BroadPhase, ALesserDistanceLeavesOutWhatIsFartherForOnceOnly) {
  Scene scene = heap(2, 0.2);
  const ContactFeatures features(scene.bodies());
  ContactWork work;
  BroadPhase broad(features, scene.bodies(), scene.settings, work);
  std::vector<char> awake(scene.bodies().size(), 1);
  awake[0] = 0;
  std::mt19937 random(3);
  for (int step = 0; step < 20; ++step) {
    for (int b = 1; b < static_cast<int>(awake.size()); ++b) disturb(scene, b, 0.01, random);
    broad.read_motion(scene.x);
    const double lesser = 0.05 * step / 20;
    std::vector<FacePair> within = all_near(broad, features, scene.x, 0.3, awake);
    const std::vector<FacePair> all = within;
    std::erase_if(within, [&](const FacePair& pair) {
      Box a, b;
      for (int node : features.outline(pair.a)) a.add(scene.x[node]);
      for (int node : features.outline(pair.b)) b.add(scene.x[node]);
      return !a.within(b, lesser);
    });
    EXPECT_LT(within.size(), all.size());
    expect_same(broad.find(scene.x, 0.3, [&](int, int) { return lesser; }), within, step);
    expect_same(broad.find(scene.x, 0.3), all, step);
  }
}

INSTANTIATE_TEST_SUITE_P(BroadPhase, AnyMotion,
                         ::testing::Values(Trial{0.02, 0, false}, Trial{0.02, 0, true}, Trial{0.5, 0, true},
                                           Trial{0.02, 1e6, true}, Trial{0.1, 1e6, false}));

TEST(BroadPhase, FindsTheSameWhileBodiesFallAsleepWakeAndAreHeld) {
  Scene scene = heap(3, 0.02);
  const ContactFeatures features(scene.bodies());
  ContactWork work;
  BroadPhase broad(features, scene.bodies(), scene.settings, work);
  std::vector<ContactBody> bodies = scene.bodies();
  std::vector<char> asleep(bodies.size(), 0), awake(bodies.size(), 1);
  awake[0] = 0;
  std::mt19937 random(3);
  std::uniform_int_distribution<int> any(1, static_cast<int>(bodies.size()) - 1);
  for (int step = 0; step < 200; ++step) {
    for (int change = 0; change < 3; ++change) {
      const int b = any(random);
      asleep[b] = !asleep[b];
      broad.set_asleep(b, asleep[b]);
      awake[b] = !asleep[b] && !bodies[b].fixed;
    }
    if (step % 50 == 25) {
      for (int b = 1; b < static_cast<int>(bodies.size()); ++b) {
        bodies[b].fixed = b % 3 == step / 50 % 3;
        awake[b] = !asleep[b] && !bodies[b].fixed;
      }
      broad.set_bodies(bodies);
    }
    for (int b = 1; b < static_cast<int>(bodies.size()); ++b) {
      if (awake[b]) broad.moved(b, disturb(scene, b, 0.01, random));
    }
    expect_same(broad.find(scene.x, 0.01), all_near(broad, features, scene.x, 0.01, awake), step);
  }
}

/// Work of `steps` steps in which `move` moves bodies of the scene.
ContactWork work_of(BroadPhase& broad, const ContactWork& after, Scene& scene, int steps,
                    const std::function<void()>& move) {
  const ContactWork before = after;
  for (int step = 0; step < steps; ++step) {
    move();
    broad.find(scene.x, 1e-3);
  }
  return {after.body_pairs - before.body_pairs, after.searches - before.searches,
          after.facet_pairs_searched - before.facet_pairs_searched, after.facet_pairs - before.facet_pairs, 0};
}

TEST(BroadPhase, BlocksFarApartAreNotLookedAt) {
  Scene scene = heap(4, 30);
  const ContactFeatures features(scene.bodies());
  ContactWork work;
  BroadPhase broad(features, scene.bodies(), scene.settings, work);
  broad.find(scene.x, 1e-3);
  const ContactWork done = work_of(broad, work, scene, 40, [&] {
    for (int b = 17; b < 65; ++b) {  // those that lie on nothing
      scene.move(b, {0.02, 0, 0});
      broad.moved(b, 0.02);
    }
  });
  EXPECT_EQ(done.body_pairs, 0);
  EXPECT_EQ(done.searches, 0);
}

TEST(BroadPhase, OneThatFliesDoesNotMakeTheOthersBeSearched) {
  Scene scene = heap(3, 0.02);
  const ContactFeatures features(scene.bodies());
  ContactWork work;
  BroadPhase broad(features, scene.bodies(), scene.settings, work);
  broad.find(scene.x, 1e-3);
  scene.move(27, {0, 0, 10});
  broad.moved(27, 10);
  broad.find(scene.x, 1e-3);
  const ContactWork done = work_of(broad, work, scene, 50, [&] {
    scene.move(27, {0, 0, 0.3});
    broad.moved(27, 0.3);
  });
  EXPECT_EQ(done.searches, 0);
  EXPECT_LE(done.body_pairs, 27);  // each of the others once, until it is gone
}

TEST(BroadPhase, NeighboursThatTouchNothingAreNotLookedAtInEveryStep) {
  // One cube 0.4 over the other, coming down: farther than the search distance of 0.3 h until it has come down to it.
  Scene scene;
  scene.add(box({0, 0, 0}, {1, 1, 1}), true);
  scene.add(box({0, 0, 1.4}, {1, 1, 2.4}));
  const ContactFeatures features(scene.bodies());
  ContactWork work;
  BroadPhase broad(features, scene.bodies(), scene.settings, work);
  const auto come_down = [&] {
    scene.move(1, {0, 0, -1e-4});
    broad.moved(1, 1e-4);
  };
  work_of(broad, work, scene, 1, come_down);
  const ContactWork above = work_of(broad, work, scene, 900, come_down);
  EXPECT_LE(above.searches, 5);
  EXPECT_LE(above.facet_pairs, 5 * 144);
  const ContactWork near = work_of(broad, work, scene, 200, come_down);
  EXPECT_GE(near.facet_pairs, 90 * 2);
}

}  // namespace
}  // namespace talus
