#include "solve/equilibrium/interior_point.hpp"

#include <gmock/gmock.h>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

constexpr double stiffness = 1e7, normal_stiffness = 1e9, shear_stiffness = 4e8;  // N/m
constexpr double friction = 0.5;

/// The corners of a block, each on a spring of its own; the first one touches the ground.
class CornerOnGround : public testing::Test {
 protected:
  CornerOnGround()
      : system(test::block_system({test::box_block("block", Vec3(0, 0, 0), Vec3(1, 1, 1)),
                                   test::box_block("ground", Vec3(0, 0, -1), Vec3(1, 1, 0), BodyKind::fixed)})),
        set(test::rock_project(30, {}), system),
        pattern(set.unknowns() / 3, {}),
        load(Eigen::VectorXd::Zero(set.unknowns())) {
    ContactPoint point{};
    point.normal = Vec3::UnitZ();
    point.size = 1;
    point.normal_stiffness = normal_stiffness;
    point.shear_stiffness = shear_stiffness;
    point.friction = friction;
    point.stencil_end = 1;
    contacts.points = {point};
    contacts.nodes = {0};
    contacts.weights = {1};
    contacts.sort_out();
    links.connect();
  }
  /// D of the corner [m] under a load on it [N], after at most so many iterations.
  Vec3 moved(const Vec3& on_corner, int limit = 60, const PickedBodies* picked = nullptr) {
    load.segment<3>(corner()) = on_corner;
    Increment d = Increment::Zero(set.unknowns());
    const InteriorPoint::Problem problem{
        .bodies = set,
        .links = links,
        .pattern = pattern,
        .picked = picked,
        .add_gradient = [&](const Increment& at, Eigen::VectorXd& sum) { sum += stiffness * at - load; },
        .assemble =
            [&](const Increment&, SymmetricBlocks& matrix, UnsymmetricBlocks&) {
              matrix.set_zero();
              for (int i = 0; i < set.unknowns() / 3; ++i) matrix.add(i, i, stiffness * Mat3::Identity());
            },
        .longest_step_fraction = [](const Increment&, const Eigen::VectorXd&) { return 1.0; },
        .is_near = [&](const Increment& at) { return near_of(at.segment<3>(corner())); }};
    iterations = InteriorPoint().approach(problem, limit, d);
    return d.segment<3>(corner());
  }
  /// By the law itself: is the residual below a millionth?
  bool near_of(const Vec3& at) const {
    const double pressed = std::max(0.0, -normal_stiffness * at.z());
    Vec3 shear(-shear_stiffness * at.x(), -shear_stiffness * at.y(), 0);
    if (shear.norm() > friction * pressed) shear *= friction * pressed / shear.norm();
    const Vec3 left = stiffness * at - load.segment<3>(corner()) - shear - pressed * Vec3::UnitZ();
    return left.norm() < 1e-6 * load.norm();
  }
  int corner() const { return 3 * set.nodes.dof_block[0]; }

  BlockSystem system;
  BodySet set;
  BlockPattern pattern;
  Eigen::VectorXd load;
  ContactSet contacts;
  ContactLinks links{set, contacts};
  int iterations = 0;
};

TEST_F(CornerOnGround, SlidesAgainstFrictionAlone) {
  const Vec3 at = moved(Vec3(900, 0, -1000));
  const double pressed = 1000 * normal_stiffness / (normal_stiffness + stiffness);
  EXPECT_NEAR(at.x(), (900 - friction * pressed) / stiffness, 1e-6 * 900 / stiffness);
  EXPECT_NEAR(at.z(), -pressed / normal_stiffness, 1e-5 * pressed / normal_stiffness);
  EXPECT_LT(iterations, 20);
}

TEST_F(CornerOnGround, SticksBelowItsStrength) {
  const Vec3 at = moved(Vec3(100, 200, -1000));
  EXPECT_NEAR(at.x(), 100 / (shear_stiffness + stiffness), 1e-4 * 100 / shear_stiffness);
  EXPECT_NEAR(at.y(), 200 / (shear_stiffness + stiffness), 1e-4 * 200 / shear_stiffness);
  EXPECT_LT(iterations, 20);
}

TEST_F(CornerOnGround, MovesAloneAsWithAll) {
  const Vec3 with_all = moved(Vec3(900, 0, -1000));
  PickedBodies picked;
  picked.places = {0};
  for (int block = 0; block < pattern.nodes(); ++block) picked.dof_blocks.push_back(block);
  picked.has = {1, 0};
  EXPECT_LT((moved(Vec3(900, 0, -1000), 60, &picked) - with_all).norm(), 1e-9 * with_all.norm());
  EXPECT_LT(iterations, 20);
  picked.places.clear();
  picked.dof_blocks = {pattern.nodes() - 1};  // the corner is held
  picked.has = {0, 0};
  EXPECT_EQ(moved(Vec3(900, 0, -1000), 3, &picked), Vec3(Vec3::Zero()));
}

TEST_F(CornerOnGround, IsLiftedFreely) {
  EXPECT_LT((moved(Vec3(100, 200, 1000)) - Vec3(100, 200, 1000) / stiffness).norm(), 1e-5 * 1000 / stiffness);
  EXPECT_LT(iterations, 20);
}

TEST_F(CornerOnGround, GoesNoFurtherThanItMay) {
  moved(Vec3(900, 0, -1000), 3);
  EXPECT_EQ(iterations, 3);
}

}  // namespace
}  // namespace talus
