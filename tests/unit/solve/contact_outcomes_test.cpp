#include "solve/contact_outcomes.hpp"

#include <gmock/gmock.h>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

/// A corner of the cube against the slab, 1 m of mesh size, held to a thousandth of it.
class PenaltyScaling : public testing::Test {
 protected:
  PenaltyScaling() : set_(test::rock_project(30, {}), test::cube_on_slab()), links_(set_, contacts_) {}

  bool scales_penalty(double gap, double initial_interference, double change) {
    ContactPoint point{};
    point.normal = Vec3::UnitZ();
    point.gap = gap;
    point.initial_interference = initial_interference;
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
    return scale_penalty(contacts_, links_, d, 1e-3, as_given_);
  }
  const ContactPoint& point() const { return contacts_.points[0]; }

  BodySet set_;
  ContactSet contacts_;
  ContactLinks links_;
  std::vector<Joint> as_given_;
};

TEST_F(PenaltyScaling, StiffensAContactThatGoesTooDeepAndKeepsItsForce) {
  ASSERT_TRUE(scales_penalty(-9e-4, 0, -2e-4));
  EXPECT_DOUBLE_EQ(point().normal_stiffness, 3e10);
  EXPECT_DOUBLE_EQ(point().shear_stiffness, 1e10);
  EXPECT_DOUBLE_EQ(point().normal_stiffness * point().gap, -3e9 * 9e-4);
  EXPECT_DOUBLE_EQ(point().initial_interference - point().gap, 9e-4);
}

TEST_F(PenaltyScaling, KeepsAContactThatOpensOrIsNotDeep) {
  EXPECT_FALSE(scales_penalty(-2e-3, 0, 1e-5));
  EXPECT_FALSE(scales_penalty(-5e-4, 0, -1e-4));
}

TEST_F(PenaltyScaling, KeepsTheStiffnessThatAJointWasGiven) {
  as_given_.resize(1);
  EXPECT_TRUE(scales_penalty(-9e-4, 0, -2e-4));
  as_given_[0].normal_stiffness = 3e9;
  EXPECT_FALSE(scales_penalty(-9e-4, 0, -2e-4));
}

TEST_F(PenaltyScaling, KeepsAContactThatIsDeepByInitialInterferenceAlone) {
  EXPECT_FALSE(scales_penalty(-1e-5, 2e-3, -5e-6));
  EXPECT_TRUE(scales_penalty(-1e-5, 2e-3, -5e-5));
}

}  // namespace
}  // namespace talus
