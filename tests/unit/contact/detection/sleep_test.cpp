#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "unit/contact/blocks.hpp"

/// Bodies that are asleep cost nothing, and when they wake it is as if they had been awake.
namespace talus {
namespace {

using testing::box;
using testing::reach;
using testing::Scene;

/// Columns of three blocks that lie a little in each other, bonded or not, on a slab.
Scene columns(int count, const JointLaw& law) {
  Scene scene;
  scene.laws = {law};
  scene.add(box({0, 0, -1}, {2.0 * count + 1, 3, 0}, {3, 2, 1}), true);
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) {
      const double x = 2.0 * i + 1 + 0.01 * k, z = k - 1e-4 * (k + 1);
      scene.add(box({x, 1, z}, {x + 1, 2, z + 1}, {1 + k, 2, 1}, k == 1));
    }
  }
  return scene;
}

/// What a step of contacts at rest comes to; different for every contact.
void accept(Scene& scene, double slip = 1e-3) {
  std::vector<ContactOutcome> outcomes(scene.contacts.points.size());
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    ContactPoint& p = scene.contacts.points[i];
    const double force = std::max(0.0, -p.gap * p.normal_stiffness);
    p.mode = p.gap <= 0 ? ContactMode::stick : ContactMode::open;
    outcomes[i].normal_force = force;
    outcomes[i].shear_force = 0.1 * force * p.normal.unitOrthogonal() + p.position.y() * p.normal.unitOrthogonal();
    outcomes[i].gap = p.gap;
    outcomes[i].slip = slip;
    outcomes[i].multiplier = 0.5 * force;
    outcomes[i].broke = p.bonded && p.key % 5 == 0;
  }
  scene.detector().accept(scene.contacts, outcomes);
}

void expect_same_bits(const ContactSet& a, const ContactSet& b) {
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const ContactPoint &p = a.points[i], &q = b.points[i];
    EXPECT_EQ(p.key, q.key);
    EXPECT_EQ(p.position, q.position);
    EXPECT_EQ(p.normal, q.normal);
    EXPECT_EQ(p.shear_start, q.shear_start);
    EXPECT_EQ(p.mode, q.mode);
    EXPECT_EQ(p.bonded, q.bonded);
    const auto numbers = [](const ContactPoint& r) {
      return std::array{r.gap,
                        r.initial_interference,
                        r.size,
                        r.area,
                        r.normal_stiffness,
                        r.shear_stiffness,
                        r.friction,
                        r.cohesion,
                        r.tension,
                        r.slip_start,
                        r.multiplier};
    };
    EXPECT_EQ(numbers(p), numbers(q));
  }
  EXPECT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(a.weights, b.weights);
}

void step(Scene& scene, int steps, double slip = 1e-3) {
  for (int i = 0; i < steps; ++i) {
    scene.detect(reach);
    accept(scene, slip);
  }
}

class Sleep : public ::testing::TestWithParam<JointLaw> {};

TEST_P(Sleep, ContactsGoOnToTheBitWhereNothingMovedInBetween) {
  // One step's outcome, then steps that would repeat it: with and without the lower ones asleep in between.
  Scene awake = columns(2, GetParam()), sleeping = columns(2, GetParam());
  step(awake, 2);
  step(sleeping, 2);
  sleeping.detector().set_asleep({0, 1, 1, 0, 1, 1, 1});
  const ContactSet before = awake.detect(reach);
  sleeping.detect(reach);
  // The upper one of the first column is awake: its contacts with the sleeper are as they were.
  EXPECT_FALSE(sleeping.contacts.points.empty());
  for (const ContactPoint& p : sleeping.contacts.points) EXPECT_EQ(p.bodies[1], 3);
  // It wakes what it rests on, in the same step; then the others wake, too.
  sleeping.detector().set_asleep({0, 1, 0, 0, 1, 1, 1});
  sleeping.detect(reach);
  sleeping.detector().set_asleep({0, 0, 0, 0, 0, 0, 0});
  expect_same_bits(sleeping.detect(reach), before);
  accept(awake);
  accept(sleeping);
  expect_same_bits(sleeping.detect(reach), awake.detect(reach));
}

TEST_P(Sleep, StepsOfOthersLeaveTheMemoryOfSleepersAlone) {
  Scene awake = columns(2, GetParam()), sleeping = columns(2, GetParam());
  step(awake, 2);
  step(sleeping, 2);
  sleeping.detector().set_asleep({0, 1, 1, 1, 0, 0, 0});
  for (int i = 0; i < 5; ++i) {  // the other column slides
    for (int b = 4; b < 7; ++b) sleeping.move(b, {0, 0.01, 0});
    step(sleeping, 1);
  }
  sleeping.detector().set_asleep({0, 0, 0, 0, 0, 0, 0});
  const auto of_the_first_column = [](const ContactSet& contacts) {
    ContactSet some;
    for (ContactPoint p : contacts.points) {
      if (p.bodies[1] <= 3) some.points.push_back(p);
    }
    return some;
  };
  expect_same_bits(of_the_first_column(sleeping.detect(reach)), of_the_first_column(awake.detect(reach)));
}

TEST_P(Sleep, HowDeepTheyLieIsNotForgottenAndNotKeptTooLong) {
  // The lower two lie deeper in each other than the reach: found because they were there before.
  Scene awake = columns(1, GetParam()), sleeping = columns(1, GetParam());
  for (Scene* scene : {&awake, &sleeping}) {
    for (int b : {2, 3}) scene->move(b, {0, 0, -2 * reach});
    step(*scene, 2, 0);
  }
  sleeping.detector().set_asleep({0, 1, 1, 0});
  for (int i = 0; i < 3; ++i) {  // the upper one is lifted off and set down again
    for (Scene* scene : {&awake, &sleeping}) {
      scene->move(3, {0, 0, i == 0 ? 0.5 : i == 1 ? -0.5 : 0});
      step(*scene, 1, 0);
    }
  }
  sleeping.detector().set_asleep({0, 0, 0, 0});
  expect_same_bits(sleeping.detect(reach), awake.detect(reach));
  EXPECT_TRUE(std::any_of(awake.contacts.points.begin(), awake.contacts.points.end(),
                          [](const ContactPoint& p) { return p.gap < -reach; }));
  for (const double displacement :
       {0.5, 1.8 * reach - 0.5}) {  // lifted off and set down less deep: most of that is initial interference
    for (Scene* scene : {&awake, &sleeping}) {
      for (int b : {2, 3}) scene->move(b, {0, 0, displacement});
      scene->detect(reach);
    }
    expect_same_bits(sleeping.contacts, awake.contacts);
    if (displacement > 0) {
      accept(awake, 0);
      accept(sleeping, 0);
    }
  }
}

TEST_P(Sleep, ContactsAtRestCanBeShown) {
  Scene scene = columns(1, GetParam());
  step(scene, 2);
  const ContactSet last = scene.contacts;
  scene.detector().set_asleep({0, 1, 1, 1});
  EXPECT_TRUE(scene.detect(reach).points.empty());
  const std::vector<RestingContact> resting = scene.detector().resting();
  const auto remembered = [](const ContactPoint& p) { return p.mode != ContactMode::open; };
  ASSERT_EQ(static_cast<long>(resting.size()), std::count_if(last.points.begin(), last.points.end(), remembered));
  for (const RestingContact& row : resting) {
    const auto same = std::find_if(last.points.begin(), last.points.end(), [&](const ContactPoint& p) {
      return p.bodies[0] == row.bodies[0] && p.bodies[1] == row.bodies[1] && p.position == row.position &&
             p.normal == row.normal && p.area == row.area;
    });
    ASSERT_NE(same, last.points.end());
    EXPECT_EQ(row.normal_force, -same->gap * same->normal_stiffness);
    EXPECT_EQ(row.mode, ContactMode::stick);
  }
  EXPECT_TRUE(std::is_sorted(resting.begin(), resting.end(), [](const RestingContact& a, const RestingContact& b) {
    return std::pair(a.bodies[0], a.bodies[1]) < std::pair(b.bodies[0], b.bodies[1]);
  }));
  scene.detector().set_asleep({0, 0, 0, 0});
  EXPECT_TRUE(scene.detector().resting().empty());
}

INSTANTIATE_TEST_SUITE_P(Contact, Sleep,
                         ::testing::Values(JointLaw{.friction = 0.5},
                                           JointLaw{.friction = 0.6, .residual_friction = 0.2, .cohesion = 2e5}));

TEST(Sleeping, ScalesStay) {
  Scene scene = columns(1, {.friction = 0.5});
  scene.detect(reach);
  const auto upper = [&] {
    std::vector<double> stiffness;
    for (const ContactPoint& p : scene.detect(reach).points) {
      if (p.bodies[1] == 3) stiffness.push_back(p.normal_stiffness);
    }
    return stiffness;
  };
  const std::vector<double> before = upper();
  scene.detector().set_asleep({0, 1, 1, 0});
  EXPECT_EQ(upper(), before);
}

TEST(Sleeping, ABodyThatComesNearIsFound) {
  Scene scene = columns(1, {.friction = 0.5});
  scene.add(box({1, 1, 4}, {2, 2, 5}));
  step(scene, 1);
  scene.detector().set_asleep({0, 1, 1, 1, 0});
  for (int i = 0; i < 94; ++i) {
    scene.move(4, {0, 0, -0.0105});
    ASSERT_TRUE(scene.detect(reach).points.empty()) << i;
    accept(scene);
  }
  scene.move(4, {0, 0, -0.0105});
  ASSERT_FALSE(scene.detect(reach).points.empty());
  for (const ContactPoint& p : scene.contacts.points) EXPECT_EQ(p.bodies[0], 3);
}

TEST(Sleeping, EveryBodyNeedsAnEntryAndAStepItsOwnContacts) {
  Scene scene = columns(1, {.friction = 0.5});
  EXPECT_THROW(scene.detector().set_asleep({1}), std::logic_error);
  scene.detect(reach);
  scene.detector().set_asleep({0, 1, 1, 0});
  EXPECT_THROW(accept(scene), std::logic_error);
}

/// Work of 60 steps in which the last body of a scene slides over the slab, the others asleep.
ContactWork work_beside_sleepers(int sleepers) {
  Scene scene;
  scene.settings.motion_told = true;
  scene.add(box({-100, -100, -1}, {100, 100, 0}), true);
  for (int i = 0; i < sleepers; ++i) {
    const double x = 2.0 * (i % 32) - 80, y = 2.0 * (i / 32) - 80;
    scene.add(box({x, y, -1e-5}, {x + 1, y + 1, 1}));
  }
  const int last = scene.add(box({20, 20, -1e-5}, {21, 21, 1}, {2, 2, 2}));
  step(scene, 1);
  std::vector<char> asleep(scene.bodies().size(), 1);
  asleep[0] = asleep[last] = 0;
  scene.detector().set_asleep(asleep);
  const ContactWork before = scene.detector().work();
  for (int i = 0; i < 60; ++i) {
    scene.move(last, {0.01, 0, 0});
    scene.detector().moved(last, 0.01);
    step(scene, 1);
  }
  const ContactWork& after = scene.detector().work();
  return {after.body_pairs - before.body_pairs, after.searches - before.searches,
          after.facet_pairs_searched - before.facet_pairs_searched, after.facet_pairs - before.facet_pairs,
          after.points - before.points};
}

TEST(Sleeping, AThousandSleepersAddNoWork) {
  const ContactWork alone = work_beside_sleepers(0), beside = work_beside_sleepers(1000);
  EXPECT_GT(alone.points, 60 * 4);
  EXPECT_EQ(beside.body_pairs, alone.body_pairs);
  EXPECT_EQ(beside.searches, alone.searches);
  EXPECT_EQ(beside.facet_pairs_searched, alone.facet_pairs_searched);
  EXPECT_EQ(beside.facet_pairs, alone.facet_pairs);
  EXPECT_EQ(beside.points, alone.points);
}

}  // namespace
}  // namespace talus
