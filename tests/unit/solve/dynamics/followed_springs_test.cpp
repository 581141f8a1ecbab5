// How stiff the springs of new contacts are.
#include "solve/dynamics/followed_springs.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/contact_law.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

constexpr double step = 0.01, penetration = 5e-4;

/// Two cubes of 1 m and 2 m over a fixed slab, and as many contact points between each two as are asked for.
class FollowedSpringsOf : public ::testing::Test {
 protected:
  void build(BodyKind small) {
    system_ = test::block_system({test::box_block("slab", Vec3(-5, -5, -1), Vec3(5, 5, 0), BodyKind::fixed),
                                  test::box_block("small", Vec3(0, 0, 0), Vec3(1, 1, 1), small),
                                  test::box_block("large", Vec3(0, 0, 1), Vec3(2, 2, 3), BodyKind::rigid)});
    bodies_.emplace(project_, system_);
  }
  void add_points(int count, int first, int second) {
    for (int i = 0; i < count; ++i) {
      ContactPoint point;
      point.bodies[0] = first, point.bodies[1] = second;
      point.size = 1;
      point.normal_stiffness = 1e11, point.shear_stiffness = 4e10;
      contacts_.points.push_back(point);
    }
  }
  void limit(double length = step, FollowedContacts which = FollowedContacts::new_ones) {
    FollowedSprings(*bodies_, {}).limit(project_, length, penetration, which, contacts_);
  }
  double stiffness_between(int first, int second) const {
    double sum = 0;
    for (const ContactPoint& p : contacts_.points)
      if (p.bodies[0] == first && p.bodies[1] == second) sum += p.normal_stiffness;
    return sum;
  }

  Project project_ = test::rock_project(30, {{"fall", StageKind::dynamic, step, 1, {}}});
  BlockSystem system_;
  std::optional<BodySet> bodies_;
  ContactSet contacts_;
};

constexpr double small_mass = 2600, large_mass = 8 * 2600;

TEST_F(FollowedSpringsOf, TwoRigidBodiesLetThemSwingOnceAStep) {
  build(BodyKind::rigid);
  add_points(4, 1, 2);
  add_points(3, 0, 1);
  limit();
  const double squared = std::pow(2 * M_PI / step, 2);
  EXPECT_NEAR(stiffness_between(1, 2), squared / (1 / small_mass + 1 / large_mass), 1e-3);
  EXPECT_NEAR(stiffness_between(0, 1), squared * small_mass, 1e-3) << "a fixed body is as heavy as can be";
  for (const ContactPoint& p : contacts_.points) {
    EXPECT_NEAR(p.normal_stiffness, p.penalty_scaling * 1e11, 1e-3);
    EXPECT_NEAR(p.shear_stiffness, p.penalty_scaling * 4e10, 1e-3);
  }
}

TEST_F(FollowedSpringsOf, LongStepsBearTheWeightWithinTheAllowedPenetration) {
  build(BodyKind::rigid);
  add_points(4, 0, 1);
  limit(10);
  EXPECT_NEAR(small_mass * project_.gravity.norm() / stiffness_between(0, 1), penetration, 1e-9);
}

TEST_F(FollowedSpringsOf, ShortStepsChangeNothing) {
  build(BodyKind::rigid);
  add_points(4, 1, 2);
  limit(1e-6);
  EXPECT_EQ(stiffness_between(1, 2), 4e11);
}

TEST_F(FollowedSpringsOf, ContactsThatGoOnKeepTheirs) {
  build(BodyKind::rigid);
  add_points(2, 1, 2);
  contacts_.points[0].is_new = false;
  contacts_.points[0].penalty_scaling = 0.5;
  contacts_.points[0].normal_stiffness *= 0.5;
  limit();
  EXPECT_EQ(contacts_.points[0].normal_stiffness, 5e10);
  EXPECT_EQ(contacts_.points[1].normal_stiffness, 5e10) << "as stiff as what goes on between the same bodies";
}

TEST_F(FollowedSpringsOf, WhereAllAreToFollowThoseThatGoOnGetSofterAndHoldNoMore) {
  build(BodyKind::rigid);
  add_points(2, 1, 2);
  ContactPoint& goes_on = contacts_.points[0];
  goes_on.is_new = false;
  goes_on.shear_start = {3e3, 0, 0};
  const double before = shear_spring_energy(goes_on, goes_on.shear_start);
  limit(step, FollowedContacts::all);
  EXPECT_NEAR(stiffness_between(1, 2), std::pow(2 * M_PI / step, 2) / (1 / small_mass + 1 / large_mass), 1e-3);
  EXPECT_EQ(goes_on.normal_stiffness, contacts_.points[1].normal_stiffness);
  EXPECT_NEAR(shear_spring_energy(goes_on, goes_on.shear_start), before, 1e-9 * before);
}

TEST_F(FollowedSpringsOf, OnesThatGoOnAreNeverMadeStiffer) {
  build(BodyKind::rigid);
  add_points(2, 1, 2);
  contacts_.points[0].is_new = false;
  contacts_.points[0].penalty_scaling = 1e-6;
  contacts_.points[0].normal_stiffness *= 1e-6;
  limit(step, FollowedContacts::all);
  EXPECT_NEAR(contacts_.points[0].normal_stiffness, 1e5, 1e-6);
}

TEST_F(FollowedSpringsOf, WhereNoneIsToFollowAllKeepTheirs) {
  build(BodyKind::rigid);
  add_points(1, 1, 2);
  limit(step, FollowedContacts::none);
  EXPECT_EQ(stiffness_between(1, 2), 1e11);
}

TEST_F(FollowedSpringsOf, JointsThatHaveAStiffnessKeepIt) {
  project_.joints[0].normal_stiffness = 1e11;
  build(BodyKind::rigid);
  add_points(1, 1, 2);
  limit();
  EXPECT_EQ(stiffness_between(1, 2), 1e11);
}

TEST_F(FollowedSpringsOf, MeshedBlocksYieldNoMoreThanElementsBesideThem) {
  build(BodyKind::tetrahedra);
  add_points(1, 1, 2);
  limit();
  ASSERT_EQ(project_.solver.contact_stiffness, 10) << "E*/h";
  EXPECT_NEAR(stiffness_between(1, 2), 1e10, 1e-3) << "E*/h";
}

TEST_F(FollowedSpringsOf, MeshedBlocksKeepTheirsInStepsThatResolveWaves) {
  build(BodyKind::tetrahedra);
  add_points(1, 1, 2);
  limit(1e-4);
  EXPECT_EQ(stiffness_between(1, 2), 1e11);
}

/// A point between two blocks that slide on each other at 1 m/s, which a blow has made stiff. Now its spring gives by
/// so much of the penetration that it may have; as much again is initial interference.
class StiffenedByABlow : public FollowedSpringsOf {
 protected:
  StiffenedByABlow() {
    build(BodyKind::rigid);
    for (int n = bodies_->bodies[1].first_node; n < bodies_->bodies[2].first_node; ++n)
      bodies_->nodes.velocity[n] = {1, 0, 0};
    add_points(1, 1, 2);
    point().penalty_scaling = 10, point().normal_stiffness *= 10, point().shear_stiffness *= 10;
    contacts_.nodes = {bodies_->bodies[1].first_node, bodies_->bodies[2].first_node};
    contacts_.weights = {1, -1};
    point().stencil_end = 2;
    point().is_new = false;
    gives_by(1e-4);
  }
  ContactPoint& point() { return contacts_.points[0]; }
  void gives_by(double compression) {
    point().gap = -compression * penetration;
    point().initial_interference = compression * penetration;
    point().shear_start = {0.1 * normal_force(point(), point().gap), 0, 0};
  }
  bool softens() {
    const double before = point().normal_stiffness;
    limit();
    return point().normal_stiffness < before;
  }
};

TEST_F(StiffenedByABlow, ASpringThatHardlyGivesIsLetGoSoftWithoutEnergy) {
  gives_by(1e-5);
  const ContactPoint before = point();
  ASSERT_TRUE(softens());
  const double followed = std::pow(2 * M_PI / step, 2) / (1 / small_mass + 1 / large_mass);
  EXPECT_NEAR(point().normal_stiffness, followed, 1e-3) << "no softer than a step can follow";
  EXPECT_NEAR(point().penalty_scaling, 10 * followed / before.normal_stiffness, 1e-15);
  EXPECT_LT(normal_force(point(), point().gap), normal_force(before, before.gap));
  EXPECT_LT(normal_spring_energy(point(), normal_force(point(), point().gap)),
            normal_spring_energy(before, normal_force(before, before.gap)));
  EXPECT_NEAR(shear_spring_energy(point(), point().shear_start), shear_spring_energy(before, before.shear_start),
              1e-9 * shear_spring_energy(before, before.shear_start));
  EXPECT_EQ(point().initial_interference, 0);
  EXPECT_DOUBLE_EQ(point().gap - point().initial_interference, before.gap - before.initial_interference)
      << "nobody has moved";
}

TEST_F(StiffenedByABlow, AsMuchEnergyStaysWhereTheInterferenceAllowsIt) {
  point().initial_interference = 0.1 * penetration;
  const double before = normal_spring_energy(point(), normal_force(point(), point().gap));
  ASSERT_TRUE(softens());
  EXPECT_NEAR(normal_spring_energy(point(), normal_force(point(), point().gap)), before, 1e-9 * before);
}

TEST_F(StiffenedByABlow, NewPointsBetweenTheSameBodiesAreAsSoft) {
  add_points(1, 1, 2);
  ASSERT_TRUE(softens());
  EXPECT_DOUBLE_EQ(contacts_.points[1].penalty_scaling, point().penalty_scaling);
}

TEST_F(StiffenedByABlow, AsLongAsItBearsItStaysStiff) {
  gives_by(0.02);
  EXPECT_FALSE(softens());
}

TEST_F(StiffenedByABlow, AsLongAsOneOfItsPairBearsItStaysStiff) {
  contacts_.points.push_back(point());
  contacts_.points[1].gap = -0.5 * penetration;
  EXPECT_FALSE(softens());
}

TEST_F(StiffenedByABlow, BlocksThatRestDoNotSink) {
  for (Vec3& velocity : bodies_->nodes.velocity) velocity *= 0.9 * penetration / step;
  EXPECT_FALSE(softens());
  for (Vec3& velocity : bodies_->nodes.velocity) velocity *= 1.2;
  EXPECT_TRUE(softens());
}

TEST_F(StiffenedByABlow, WhatIsDeepByInterferenceStaysStiff) {
  point().initial_interference = 0.3 * penetration;
  EXPECT_FALSE(softens());
}

TEST_F(StiffenedByABlow, NotOneThatIsNoStifferThanRock) {
  point().penalty_scaling = 1, point().normal_stiffness /= 10, point().shear_stiffness /= 10;
  EXPECT_FALSE(softens());
}

TEST_F(StiffenedByABlow, BondsStayStiff) {
  point().bonded = true;
  EXPECT_FALSE(softens());
}

}  // namespace
}  // namespace talus
