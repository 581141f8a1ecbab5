#include <gtest/gtest.h>

#include <cmath>

#include "base/units.hpp"
#include "unit/contact/blocks.hpp"

/// Contacts at the end of a step that nothing at its start told of.
namespace talus {
namespace {

using testing::box;
using testing::mapped;
using testing::Scene;

/// A cube over a slab, rotated about its lower edge along y until its lower right corners are in the slab.
class MissedContact : public ::testing::Test {
 protected:
  MissedContact() {
    scene_.add(box({-3, -3, -1}, {3, 3, 0}), true);
    scene_.add(box({0, 0, 0.1}, {1, 1, 1.1}));
    end_ = scene_.x;
    const Mat3 turn = Eigen::AngleAxisd(std::asin(0.12), Vec3::UnitY()).toRotationMatrix();
    for (int i = 0; i < scene_.node_count(1); ++i) {
      Vec3& p = end_[scene_.first_node(1) + i];
      p = turn * (p - Vec3(0, 0, 0.1)) + Vec3(0, 0, 0.1);
    }
  }
  Scene scene_;
  std::vector<Vec3> end_;
};

TEST_F(MissedContact, WhatRotatesIntoAnotherIsFoundWithItsDepth) {
  scene_.detect(0.01);
  const auto missed = scene_.detector().missed_contacts(end_, 0.5, 1e-3);
  ASSERT_FALSE(missed.empty());
  double deepest = 0;
  for (const ContactDetector::MissedContact& contact : missed) {
    EXPECT_EQ(contact.bodies[0], 0);
    EXPECT_EQ(contact.bodies[1], 1);
    EXPECT_NEAR(contact.position.x(), std::sqrt(1 - 0.12 * 0.12), 0.03);
    deepest = std::max(deepest, contact.depth);
  }
  EXPECT_NEAR(deepest * scene_.size(1), 0.02, 1e-3);
}

TEST_F(MissedContact, WhatTheStepKnowsAndWhatIsNotSoDeepIsNot) {
  ASSERT_FALSE(scene_.detect(0.2).points.empty());
  EXPECT_TRUE(scene_.detector().missed_contacts(end_, 0.5, 1e-3).empty());
  scene_.detect(0.01);
  EXPECT_TRUE(scene_.detector().missed_contacts(end_, 0.5, 0.1).empty());
}

TEST_F(MissedContact, LookingAheadChangesNothingThatIsFoundAtTheStart) {
  const ContactSet before = scene_.detect(0.2);
  scene_.detector().missed_contacts(end_, 0.5, 1e-3);
  const ContactSet& after = scene_.detect(0.2);
  ASSERT_EQ(after.points.size(), before.points.size());
  for (std::size_t i = 0; i < before.points.size(); ++i) {
    EXPECT_EQ(after.points[i].key, before.points[i].key);
    EXPECT_EQ(after.points[i].gap, before.points[i].gap);
    EXPECT_EQ(after.points[i].normal, before.points[i].normal);
  }
}

}  // namespace
}  // namespace talus
