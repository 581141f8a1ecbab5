#include "solve/penalty_scaling.hpp"

#include <gmock/gmock.h>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

BlockSystem cube_on_slab(BodyKind body) {
  BlockSystem system = test::cube_on_slab();
  system.blocks[1].body = body;
  return system;
}

/// Corners of the cube against the slab, 1 m of mesh size, held to a thousandth of it, faces to four in all.
class SpringsOfACube : public testing::Test {
 protected:
  explicit SpringsOfACube(BodyKind body = BodyKind::tetrahedra)
      : set_(test::rock_project(30, {}), cube_on_slab(body)), links_(set_, contacts_) {}

  void add_point(double gap, double initial_interference, double area = 0) {
    ContactPoint point{};
    point.bodies[1] = 1;
    point.normal = Vec3::UnitZ();
    point.gap = gap;
    point.initial_interference = initial_interference;
    point.size = 1;
    point.area = area;
    point.normal_stiffness = 3e9;
    point.shear_stiffness = 1e9;
    point.stencil_begin = static_cast<int>(contacts_.nodes.size());
    point.stencil_end = point.stencil_begin + 1;
    contacts_.points.push_back(point);
    contacts_.nodes.push_back(8);
    contacts_.weights.push_back(1);
  }
  bool stiffens(double change) {
    contacts_.sort_out();
    links_.connect();
    Increment d = Increment::Zero(set_.unknowns());
    for (int n = 0; n < set_.nodes.movable; ++n) d[3 * n + 2] = change;
    return scaling_.scale(contacts_, links_, d, {1e-3, 4e-3}, as_given_);
  }
  bool stiffens_one(double gap, double initial_interference, double change, double area = 0) {
    contacts_.clear();
    add_point(gap, initial_interference, area);
    return stiffens(change);
  }
  const ContactPoint& point() const { return contacts_.points[0]; }

  BodySet set_;
  ContactSet contacts_;
  ContactLinks links_;
  std::vector<Joint> as_given_;
  PenaltyScaling scaling_{set_};
};

TEST_F(SpringsOfACube, AreStiffenedWhereTheyGoTooDeepAndKeepTheirForce) {
  ASSERT_TRUE(stiffens_one(-9e-4, 0, -2e-4));
  EXPECT_DOUBLE_EQ(point().normal_stiffness, 3e10);
  EXPECT_DOUBLE_EQ(point().shear_stiffness, 1e10);
  EXPECT_DOUBLE_EQ(point().normal_stiffness * point().gap, -3e9 * 9e-4);
  EXPECT_DOUBLE_EQ(point().initial_interference - point().gap, 9e-4);
}

TEST_F(SpringsOfACube, AreStiffenedAHundredfoldWhereTenfoldDidNotDo) {
  ASSERT_TRUE(stiffens_one(-9e-4, 0, -2e-4));
  ASSERT_TRUE(stiffens(-2e-4));
  EXPECT_DOUBLE_EQ(point().normal_stiffness, 3e12);
}

TEST_F(SpringsOfACube, AreStiffenedWithThoseOfTheSameBodies) {
  add_point(-9e-4, 0);
  add_point(1e-2, 0);  // open
  add_point(1e-2, 0);
  contacts_.points[2].bodies[1] = 2;
  ASSERT_TRUE(stiffens(-2e-4));
  EXPECT_DOUBLE_EQ(contacts_.points[1].normal_stiffness, 3e10);
  EXPECT_EQ(contacts_.points[2].normal_stiffness, 3e9) << "of other bodies";
}

TEST_F(SpringsOfACube, StayAsTheyAreWhereTheyOpenOrAreNotDeep) {
  EXPECT_FALSE(stiffens_one(-2e-3, 0, 1e-5));
  EXPECT_FALSE(stiffens_one(-5e-4, 0, -1e-4));
}

TEST_F(SpringsOfACube, KeepTheStiffnessThatAJointWasGiven) {
  as_given_.resize(1);
  EXPECT_TRUE(stiffens_one(-9e-4, 0, -2e-4));
  as_given_[0].normal_stiffness = 3e9;
  EXPECT_FALSE(stiffens_one(-9e-4, 0, -2e-4));
}

TEST_F(SpringsOfACube, StayAsTheyAreWhereInitialInterferenceAloneIsDeep) {
  EXPECT_FALSE(stiffens_one(-1e-5, 2e-3, -5e-6));
  EXPECT_TRUE(stiffens_one(-1e-5, 2e-3, -5e-5));
}

constexpr double of_a_face = 0.1;  // m²

class SpringsOfARigidCube : public SpringsOfACube {
 protected:
  SpringsOfARigidCube() : SpringsOfACube(BodyKind::rigid) {}
};

TEST_F(SpringsOfARigidCube, OfFacesMayGiveAlthoughTheyWereFoundDeep) {
  EXPECT_FALSE(stiffens_one(-7e-4, 3e-3, -2e-4, of_a_face));
  EXPECT_TRUE(stiffens_one(-9e-4, 3e-3, -2e-4, of_a_face)) << "the spring gives by more than a thousandth";
  EXPECT_TRUE(stiffens_one(-7e-4, 3.2e-3, -2e-4, of_a_face)) << "deeper than four in all";
}

TEST_F(SpringsOfARigidCube, OfCornersMayNot) { EXPECT_TRUE(stiffens_one(-7e-4, 3e-3, -2e-4)); }

TEST_F(SpringsOfACube, OfElementsMayNot) { EXPECT_TRUE(stiffens_one(-7e-4, 3e-3, -2e-4, of_a_face)); }

}  // namespace
}  // namespace talus
