#include "contact/passage/passage.hpp"

#include <gtest/gtest.h>

#include "contact/passage/bodies_in_each_other.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

/// A fixed wall, 0 < x < 1, and a body before it.
class Passage : public ::testing::Test {
 protected:
  void build(Block body) {
    system_ = test::block_system({test::box_block("wall", {0, -3, -3}, {1, 3, 3}, BodyKind::fixed), std::move(body)});
    set_.emplace(project_, system_);
    surfaces_.clear();
    for (const Block& block : system_.blocks) surfaces_.push_back(make_surface(block.mesh.nodes, block.surface));
    d_.setZero(set_->unknowns());
  }
  /// A plate, 2 cm thick, with its face 10 cm before the wall.
  void build_plate(BodyKind kind) { build(test::box_block("plate", {-0.12, -0.5, -0.5}, {-0.1, 0.5, 0.5}, kind)); }
  void move(const Vec3& by) {
    const Body& body = set_->bodies[1];
    if (body.kind == BodyKind::rigid) {
      d_.segment<3>(3 * set_->nodes.dof_block[set_->rigid[body.rigid].centre]) = by;
    } else {
      for (int n = body.first_free(); n < body.first_free() + body.free_count(); ++n)
        d_.segment<3>(3 * set_->nodes.dof_block[n]) = by;
    }
  }
  void turn(const Vec3& theta) {
    const RigidBody& one = set_->rigid[set_->bodies[1].rigid];
    d_.segment<3>(3 * one.rotation_dof_block) = one.radius * theta;
  }
  std::optional<DeepPair> find(double known = 0) {
    PassageCheck check(system_, *set_, surfaces_);
    return check.find(d_, 1e-3, [&](int, int) { return known; }, {});
  }

  Project project_ = test::rock_project(30, {{"run", StageKind::dynamic, 0.01, 1, {}}});
  BlockSystem system_;
  std::optional<BodySet> set_;
  std::vector<Surface> surfaces_;
  Increment d_;
};

class PassageOf : public Passage, public ::testing::WithParamInterface<BodyKind> {};

TEST_P(PassageOf, APlateIsSeenInsideTheWallAndBehindIt) {
  build_plate(GetParam());
  for (const double far : {0.3, 1.0, 1.5, 20.0}) {
    move({far, 0, 0});
    const auto pair = find();
    ASSERT_TRUE(pair) << far;
    EXPECT_EQ(std::minmax(pair->bodies[0], pair->bodies[1]), std::minmax(0, 1));
    EXPECT_GT(pair->depth, 1e-3 * pair->size);
  }
}

TEST_P(PassageOf, APlateThatStopsBeforeTheWallOrPassesBesideItIsLeftAlone) {
  build_plate(GetParam());
  for (const Vec3& way : {Vec3(0.0999, 0, 0), Vec3(0, 5, 0), Vec3(-2, 0, 9), Vec3(0.09, 4, 3)}) {
    move(way);
    EXPECT_FALSE(find()) << way.transpose();
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, PassageOf, ::testing::Values(BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra));

TEST_F(Passage, WhatContactsKnowOrWhatWasDeepBeforeIsNoPassage) {
  build_plate(BodyKind::rigid);
  move({0.13, 0, 0});
  EXPECT_TRUE(find());
  EXPECT_FALSE(find(0.031));
  build(test::box_block("plate", {-0.01, -0.5, -0.5}, {0.01, 0.5, 0.5}, BodyKind::rigid));  // 1 cm deep
  move({0, 0.2, 0});
  EXPECT_FALSE(find()) << "it slides along, as deep as before";
  move({0.2, 0.2, 0});
  EXPECT_TRUE(find());
}

/// A blade, 2 m long, that sweeps its end through a post: at neither end of the step does it touch that.
class SweepingBlade : public Passage {
 protected:
  void sweep(const Vec3& post, double angle) {
    system_ = test::block_system(
        {test::box_block("post", post - Vec3::Constant(0.01), post + Vec3::Constant(0.01), BodyKind::fixed),
         test::box_block("blade", {-1, -0.02, -0.02}, {1, 0.02, 0.02}, BodyKind::rigid)});
    set_.emplace(project_, system_);
    surfaces_.clear();
    for (const Block& block : system_.blocks) surfaces_.push_back(make_surface(block.mesh.nodes, block.surface));
    d_.setZero(set_->unknowns());
    turn({0, 0, angle});
  }
};

TEST_F(SweepingBlade, StrikesAPostOnItsArc) {
  const double angle = M_PI / 3;
  const Vec3 half_way(std::cos(angle / 2), std::sin(angle / 2), 0);
  sweep(0.98 * half_way, angle);
  EXPECT_TRUE(find()) << "the chord passes 0.13 m within";
  sweep(0.9 * half_way, angle);
  EXPECT_TRUE(find());
  sweep(1.05 * half_way, angle);
  EXPECT_FALSE(find()) << "beyond the arc";
  sweep(0.98 * Vec3(std::cos(1.2 * angle), std::sin(1.2 * angle), 0), angle);
  EXPECT_FALSE(find()) << "not reached yet";
}

TEST_F(Passage, OfABodyThatGoesLessThanHalfItsThicknessIsNotLookedFor) {
  build(test::box_block("cube", {-0.5005, 0, 0}, {-0.0005, 0.5, 0.5}, BodyKind::rigid));
  move({0.05, 0, 0});
  EXPECT_FALSE(find()) << "the next search finds it";
  move({0.1, 0, 0});
  EXPECT_TRUE(find());
}

/// Contacts hold it at the ends of a step.
TEST_F(Passage, ABladeThatTurnsPastTheWallMayBeInAsDeepAsItsArcLeavesItsChord) {
  constexpr double angle = 0.2, arm = 1;  // its tip swings from one side of the normal to the other
  Block blade = test::box_block("blade", {-2 * arm, -0.05, -0.5}, {0, 0.05, 0.5}, BodyKind::rigid);
  const auto turned = Eigen::AngleAxisd(-angle / 2, Vec3::UnitZ());
  for (Vec3& node : blade.mesh.nodes) node = turned * (node + Vec3(arm, 0, 0));
  double tip = 0;
  for (const Vec3& node : blade.mesh.nodes) tip = std::max(tip, node.x());
  for (Vec3& node : blade.mesh.nodes) node.x() -= tip;
  build(std::move(blade));
  turn({0, 0, angle});
  EXPECT_FALSE(find());
  move({2e-3, 0, 0});
  const auto pair = find();
  ASSERT_TRUE(pair) << "in too deep at the end";
  EXPECT_NEAR(pair->depth, 2e-3, 1e-9);
}

TEST_F(Passage, BodiesInEachOtherAreSeenWhereverTheyCameFrom) {
  for (const BodyKind kind : {BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra}) {
    build_plate(kind);
    BodiesInEachOther look(system_, *set_);
    EXPECT_FALSE(look.look(*set_, 1e-2));
    move({0.5, 0, 0});
    set_->move(d_);
    const auto pair = look.look(*set_, 1e-2);
    ASSERT_TRUE(pair);
    EXPECT_GT(pair->depth, 1e-2 * pair->size);
    EXPECT_GT(pair->position.x(), 0) << "in the wall";
    EXPECT_LT(pair->position.x(), 1);
    move({-0.45, 0, 0});
    set_->move(d_);
    EXPECT_FALSE(look.look(*set_, 1e-2)) << "out again";
  }
}

TEST_F(Passage, BodiesThatLayInEachOtherAtFirstMay) {
  build(test::box_block("cube", {-0.5, 0, 0}, {0.1, 0.6, 0.6}, BodyKind::rigid));
  BodiesInEachOther look(system_, *set_);
  EXPECT_FALSE(look.look(*set_, 1e-2));
  move({0.05, 0, 0});
  set_->move(d_);
  EXPECT_FALSE(look.look(*set_, 1e-2));
  set_->move(d_);
  set_->move(d_);
  const auto pair = look.look(*set_, 1e-2);
  ASSERT_TRUE(pair);
  EXPECT_NEAR(pair->depth, 0.25, 1e-9);
}

}  // namespace
}  // namespace talus
