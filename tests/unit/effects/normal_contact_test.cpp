#include "effects/normal_contact.hpp"

#include <gmock/gmock.h>

#include "effects/shear_contact.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

constexpr double gap = 1e-3;  // m

/// The corner of a rigid cube above the face of one of tetrahedra.
class CornerAboveFace : public testing::Test {
 protected:
  CornerAboveFace()
      : system(
            test::block_system({test::box_block("lower", Vec3(0, 0, 0), Vec3(1, 1, 1)),
                                test::box_block("upper", Vec3(0, 0, 1 + gap), Vec3(1, 1, 2 + gap), BodyKind::rigid)})),
        set(test::rock_project(30, {}), system) {
    ContactPoint point{};
    point.normal = Vec3::UnitZ();
    point.gap = gap;
    point.size = 1;
    point.normal_stiffness = 1e9;
    point.stencil_end = 4;
    contacts.points = {point};
    contacts.nodes = {8, 4, 5, 6};
    contacts.weights = {1, -0.5, -0.3, -0.2};
    contacts.sort_out();
    links.connect();
  }
  int rotation() const { return set.rigid[0].rotation_dof_block; }
  int centre() const { return set.nodes.dof_block[set.rigid[0].centre]; }
  bool joined(const Eigen::VectorXd& change) const {
    DisjointSets sets;
    sets.reset(set.unknowns() / 3);
    set.join_dof_blocks(sets);
    const NormalContact contact(links, NormalContact::Points::loose);
    contact.join_touching(Eigen::VectorXd::Zero(set.unknowns()), change, sets);
    return sets.first_of(centre()) == sets.first_of(4);
  }
  /// All of the lower block and the centre of the upper one move along z [m].
  Eigen::VectorXd moved(double lower, double upper) const {
    Eigen::VectorXd change = Eigen::VectorXd::Zero(set.unknowns());
    for (int n = 0; n < 8; ++n) change[3 * set.nodes.dof_block[n] + 2] = lower;
    change[3 * centre() + 2] = upper;
    return change;
  }
  BlockSystem system;
  BodySet set;
  ContactSet contacts;
  ContactLinks links{set, contacts};
};

TEST_F(CornerAboveFace, BodiesThatMayTouchInTheChangeBelongTogether) {
  EXPECT_FALSE(joined(moved(0, 0)));
  EXPECT_FALSE(joined(moved(0.4 * gap, -0.5 * gap)));
  EXPECT_TRUE(joined(moved(0.6 * gap, -0.5 * gap)));
  EXPECT_FALSE(joined(moved(-5 * gap, 5 * gap)));
}

TEST_F(CornerAboveFace, EachBodyMayMoveByAFractionOfItsOwn) {
  EXPECT_TRUE(joined(moved(5 * gap, 5 * gap))) << "the lower one first";
  EXPECT_TRUE(joined(moved(-5 * gap, -5 * gap))) << "the upper one first";
}

TEST_F(CornerAboveFace, ATurnBringsACornerDown) {
  Eigen::VectorXd change = Eigen::VectorXd::Zero(set.unknowns());
  const double angle = 3 * gap;  // about y, with an arm of half a metre
  change[3 * rotation() + 1] = angle * set.rigid[0].radius;
  EXPECT_FALSE(joined(change)) << "this corner goes up";
  EXPECT_TRUE(joined(-change));
}

TEST_F(CornerAboveFace, AContactThatOpensWhileItsStrengthIsHeldStillJoins) {
  contacts.points[0].friction = 0.5;
  contacts.points[0].shear_stiffness = 1e9;
  contacts.sort_out();
  ShearContact shear(links);
  const auto together = [&] {
    DisjointSets sets;
    sets.reset(set.unknowns() / 3);
    shear.join_with_strength(sets);
    return sets.first_of(centre()) == sets.first_of(4);
  };
  shear.update_strength(moved(0, 0));
  EXPECT_FALSE(together()) << "open, without any strength";
  shear.update_strength(moved(2 * gap, 0));
  EXPECT_FALSE(joined(moved(0, 0))) << "open again";
  EXPECT_TRUE(together());
}

TEST_F(CornerAboveFace, TheLeastGapIsThatOfTheWorstFractions) {
  Eigen::VectorXd change(set.unknowns());
  for (Eigen::Index i = 0; i < change.size(); ++i) change[i] = 1e-6 * std::sin(3.0 * i + 1);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(change.size());
  double least = 0;  // every block that brings the point nearer changes in full
  for (Eigen::Index dof_block = 0; dof_block < change.size() / 3; ++dof_block) {
    Eigen::VectorXd alone = none;
    alone.segment<3>(3 * dof_block) = change.segment<3>(3 * dof_block);
    least += std::min(0.0, links.moves().increment(0, alone).z());
  }
  ASSERT_LT(least, -1e-7);
  EXPECT_NEAR(links.moves().farthest_against(0, none, Vec3::UnitZ(), change), least, 1e-5 * -least);
}

}  // namespace
}  // namespace talus
