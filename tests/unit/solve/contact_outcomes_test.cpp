#include "solve/contact_outcomes.hpp"

#include <gmock/gmock.h>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

/// A corner of the cube against the slab, 1 m of mesh size, held to a thousandth of it.
class Hardening : public testing::Test {
 protected:
  Hardening() : set_(test::rock_project(30, {}), test::cube_on_slab()), links_(set_, contacts_) {}

  bool hardens(double gap, double overlap, double change) {
    ContactPoint point{};
    point.normal = Vec3::UnitZ();
    point.gap = gap;
    point.overlap = overlap;
    point.size = 1;
    point.normal_stiffness = 3e9;
    point.shear_stiffness = 1e9;
    point.stencil_end = 1;
    contacts_.points = {point};
    contacts_.nodes = {8};
    contacts_.weights = {1};
    contacts_.sort_out();
    links_.connect();
    Increment d = Increment::Zero(set_.unknowns());
    for (int n = 0; n < set_.nodes.movable; ++n) d[3 * n + 2] = change;
    return harden(contacts_, links_, d, 1e-3, as_given_);
  }
  const ContactPoint& point() const { return contacts_.points[0]; }

  BodySet set_;
  ContactSet contacts_;
  ContactLinks links_;
  std::vector<Joint> as_given_;
};

TEST_F(Hardening, a_contact_that_goes_too_deep_is_stiffer_both_ways_and_pushes_as_it_did) {
  ASSERT_TRUE(hardens(-9e-4, 0, -2e-4));
  EXPECT_DOUBLE_EQ(point().normal_stiffness, 3e10);
  EXPECT_DOUBLE_EQ(point().shear_stiffness, 1e10);
  EXPECT_DOUBLE_EQ(point().normal_stiffness * point().gap, -3e9 * 9e-4);
  EXPECT_DOUBLE_EQ(point().overlap - point().gap, 9e-4);
}

TEST_F(Hardening, a_contact_that_opens_or_is_not_deep_stays_as_it_is) {
  EXPECT_FALSE(hardens(-2e-3, 0, 1e-5));
  EXPECT_FALSE(hardens(-5e-4, 0, -1e-4));
}

TEST_F(Hardening, a_joint_keeps_the_stiffness_that_somebody_gave_it) {
  as_given_.resize(1);
  EXPECT_TRUE(hardens(-9e-4, 0, -2e-4));
  as_given_[0].normal_stiffness = 3e9;
  EXPECT_FALSE(hardens(-9e-4, 0, -2e-4));
}

TEST_F(Hardening, a_contact_is_not_hardened_for_what_is_in_already) {
  EXPECT_FALSE(hardens(-1e-5, 2e-3, -5e-6));
  EXPECT_TRUE(hardens(-1e-5, 2e-3, -5e-5));
}

}  // namespace
}  // namespace talus
