#include "contact/detection/normal_update.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

/// A corner of the cube, 0.1 mm above the slab, slides by 0.1 m along it; held to a thousandth of 1 m.
class NormalUpdates : public ::testing::Test {
 protected:
  NormalUpdates() : set_(test::rock_project(30, {}), test::cube_on_slab()), links_(set_, contacts_) {
    ContactPoint point{};
    point.normal = Vec3::UnitZ();
    point.gap = 3e-4;
    point.initial_interference = 2e-4;
    point.size = 1;
    point.is_new = false;
    point.shear_start = Vec3(3, 4, 0);
    point.stencil_end = 1;
    contacts_.points = {point};
    contacts_.nodes = {8};
    contacts_.weights = {1};
    contacts_.sort_out();
    links_.connect();
    increment_ = Increment::Zero(set_.unknowns());
    for (int n = 0; n < set_.nodes.movable; ++n) increment_[3 * n] = 0.1;
  }
  /// The slab rotates by this angle about y meanwhile [rad].
  bool follows(double angle) {
    const Vec3 normal(-std::sin(angle), 0, std::cos(angle));
    return update_.update(
        contacts_, links_,
        [&](int) {
          return ContactDetector::UpdatedNormal{normal, 1e-4 * std::cos(angle) - 0.1 * std::sin(angle)};
        },
        increment_, 1e-3, {});
  }
  ContactPoint& point() { return contacts_.points[0]; }

  BodySet set_;
  ContactSet contacts_;
  ContactLinks links_;
  Increment increment_;
  NormalUpdate update_;
};

TEST_F(NormalUpdates, ACornerThatSlidesUpAgainstARisingSlabTakesItsNormalAtTheEnd) {
  ASSERT_TRUE(follows(0.05));
  EXPECT_NEAR(point().normal.x(), -std::sin(0.05), 1e-15);
  EXPECT_NEAR(links_.gap(0, increment_) - point().initial_interference, 1e-4 * std::cos(0.05) - 0.1 * std::sin(0.05),
              1e-15);
  EXPECT_DOUBLE_EQ(point().initial_interference, 2e-4);
  EXPECT_NEAR(point().shear_start.norm(), 5, 1e-14);
  EXPECT_NEAR(point().shear_start.dot(point().normal), 0, 1e-14);
  EXPECT_FALSE(follows(0.05));  // it knows by now
}

TEST_F(NormalUpdates, WhatSlidesBeginsWithTheNormalInTheMiddleOfTheStep) {
  const Vec3 middle(-std::sin(0.02), 0, std::cos(0.02));
  const auto foresee = [&](double slide) {
    foresee_normals(
        contacts_, [&](const ContactPoint&) { return Vec3(slide, 0, 0.3); }, [&](int) { return middle; }, {});
  };
  const ContactTolerances tolerances;
  for (const double slide : {0.0, 0.9 * tolerances.foreseen_slide, 1.1}) foresee(slide);
  EXPECT_EQ(point().normal, Vec3(Vec3::UnitZ())) << "at rest, or gone by more than a facet";
  foresee(1.1 * tolerances.foreseen_slide);
  EXPECT_EQ(point().normal, middle);
  EXPECT_DOUBLE_EQ(point().gap, 3e-4);
  EXPECT_NEAR(point().shear_start.norm(), 5, 1e-14);
}

TEST_F(NormalUpdates, NormalsThatFallAwayOrRiseByLittleStayAsTheyAre) {
  EXPECT_FALSE(follows(-0.05));
  EXPECT_FALSE(follows(0.01));
  EXPECT_EQ(point().normal, Vec3::UnitZ());
}

TEST_F(NormalUpdates, BondedContactsKeepTheirNormals) {
  point().bonded = true;
  EXPECT_FALSE(follows(0.05));
  EXPECT_EQ(point().normal, Vec3::UnitZ());
}

TEST_F(NormalUpdates, ContactsThatSlideByLessThanATenthOfTheToleranceKeepTheirNormals) {
  for (const double size : {1.01e3, 0.99e3}) {  // it slides by 0.1 m; the tolerance is a thousandth of the size
    point().size = size;
    const auto updated = [&](int) { return ContactDetector::UpdatedNormal{Vec3::UnitZ(), -5}; };
    EXPECT_EQ(update_.update(contacts_, links_, updated, increment_, 1e-3, {}), size < 1e3);
  }
}

TEST_F(NormalUpdates, ContactsThatSlideByMoreThanAFacetHaveLeftTheirFeaturesAndKeepTheirNormals) {
  for (const double size : {0.11, 0.09}) {
    point().size = size;
    const auto updated = [&](int) { return ContactDetector::UpdatedNormal{Vec3::UnitZ(), -0.05}; };
    EXPECT_EQ(update_.update(contacts_, links_, updated, increment_, 1e-3, {}), size > 0.1);
  }
}

/// Else it would push from the start of the step on with a force that nothing has built up.
TEST_F(NormalUpdates, WhatIsNewTakesNoNormalAlongWhichItWasInBefore) {
  for (const double before : {-1.1e-3, -1.3e-3}) {
    point().is_new = true;
    point().normal = Vec3::UnitZ();
    point().gap = 3e-4;
    const Vec3 normal = Vec3(-0.1, 0, 1).normalized();
    const auto updated = [&](int) { return ContactDetector::UpdatedNormal{normal, before + 0.1 * normal.x()}; };
    EXPECT_EQ(update_.update(contacts_, links_, updated, increment_, 1e-3, {}), before > -1e-3 - 2e-4);
  }
}

TEST_F(NormalUpdates, AContactThatKnowsHowDeepItIsKeepsItsNormal) {
  // As deep by one normal as by the other, to within a thousandth of the tolerance or not.
  for (const double deeper : {0.9e-6, 1.1e-6}) {
    point().gap = point().initial_interference - 2e-3;
    const auto updated = [&](int) { return ContactDetector::UpdatedNormal{Vec3::UnitZ(), -2e-3 - deeper}; };
    EXPECT_EQ(update_.update(contacts_, links_, updated, increment_, 1e-3, {}), deeper > 1e-6);
  }
}

/// Rigid bodies that come from afar turn about one place, which is that of one of them alone.
TEST(GapsOfRigidBodies, AreThoseOfTheirPlacesAtTheEndThoughTheyTurnAboutOne) {
  const BodySet set(test::rock_project(30, {}),
                    test::block_system({test::box_block("lower", Vec3(0, 0, 0), Vec3(1, 1, 1), BodyKind::rigid),
                                        test::box_block("upper", Vec3(0, 0, 1.1), Vec3(1, 1, 2.1), BodyKind::rigid)}));
  const int upper = 8, lower = 4;  // the corner (0, 0, 1.1) above (0, 0, 1)
  ContactPoint point{};
  point.normal = Vec3::UnitZ();
  point.gap = 0.1;
  point.size = 1;
  point.bodies[0] = 1;
  point.stencil_end = 2;
  ContactSet contacts;
  contacts.points = {point};
  contacts.nodes = {upper, lower};
  contacts.weights = {1, -1};
  contacts.sort_out();
  ContactLinks links(set, contacts);
  links.connect(Arms::mean);
  Increment d = Increment::Zero(set.unknowns());
  d.segment<3>(3 * set.nodes.dof_block[set.rigid[1].centre]) = Vec3(0, 0, -0.05);
  d.segment<3>(3 * set.rigid[0].rotation_dof_block) = set.rigid[0].radius * Vec3(-0.1, 0, 0);
  d.segment<3>(3 * set.rigid[1].rotation_dof_block) = set.rigid[1].radius * Vec3(0.2, -0.1, 0);
  const Vec3 normal = Vec3(-0.1, -0.2, 1).normalized();
  const double gap = normal.dot(Vec3(0, 0, 0.1) + set.node_increment(upper, d) - set.node_increment(lower, d));
  ASSERT_LT(gap, -1e-2);
  EXPECT_GT(std::abs(normal.dot(Vec3(0, 0, 0.1) + links.moves().increment(0, d)) - gap), 1e-3);
  const auto updated = [&](int) { return ContactDetector::UpdatedNormal{normal, gap}; };
  ASSERT_TRUE(NormalUpdate().update(contacts, links, updated, d, 1e-3, {}));
  EXPECT_NEAR(links.gap(0, d), gap, 1e-14);
}

}  // namespace
}  // namespace talus
