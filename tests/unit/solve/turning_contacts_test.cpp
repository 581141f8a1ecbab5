#include "solve/turning_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

/// A corner of the cube, 0.1 mm above the slab, slides by 0.1 m along it; held to a thousandth of 1 m.
class Turning : public testing::Test {
 protected:
  Turning() : set_(test::rock_project(30, {}), test::cube_on_slab()), links_(set_, contacts_) {
    ContactPoint point{};
    point.normal = Vec3::UnitZ();
    point.gap = 3e-4;
    point.overlap = 2e-4;
    point.size = 1;
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
  /// The slab turns by this angle about y meanwhile [rad].
  bool follows(double angle) {
    const Vec3 normal(-std::sin(angle), 0, std::cos(angle));
    return follow_turning(
        contacts_, links_,
        [&](int) {
          return ContactDetector::Turned{normal, 1e-4 * std::cos(angle)};
        },
        increment_, 1e-3);
  }
  const ContactPoint& point() const { return contacts_.points[0]; }

  BodySet set_;
  ContactSet contacts_;
  ContactLinks links_;
  Increment increment_;
};

TEST_F(Turning, what_rises_in_front_of_a_sliding_corner_is_known_by_the_normal_it_comes_to) {
  ASSERT_TRUE(follows(0.05));
  EXPECT_NEAR(point().normal.x(), -std::sin(0.05), 1e-15);
  EXPECT_NEAR(links_.gap(0, increment_) - point().overlap, 1e-4 * std::cos(0.05) - 0.1 * std::sin(0.05), 1e-15);
  EXPECT_DOUBLE_EQ(point().overlap, 2e-4);
  EXPECT_NEAR(point().shear_start.norm(), 5, 1e-14);
  EXPECT_NEAR(point().shear_start.dot(point().normal), 0, 1e-14);
  EXPECT_FALSE(follows(0.05));  // it knows by now
}

TEST_F(Turning, what_falls_away_or_rises_by_little_stays_as_it_is) {
  EXPECT_FALSE(follows(-0.05));
  EXPECT_FALSE(follows(0.01));
  EXPECT_EQ(point().normal, Vec3::UnitZ());
}

}  // namespace
}  // namespace talus
