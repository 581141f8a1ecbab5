#include "solve/equilibrium/nonlinear_elimination.hpp"

#include <gtest/gtest.h>

#include "support/solver_scenes.hpp"
#include "support/spring_chain.hpp"

namespace talus {
namespace {

constexpr int rows = 15, chip = 2 * rows + 1;  // number of the chip's body

/// Rows of two cubes on a slab that slopes. The lower of the first row is held, and the upper presses a chip of a
/// centimetre against it.
BlockSystem rows_with_a_chip() {
  std::vector<Block> list{test::box_block("slab", Vec3(-5, -5, -1), Vec3(20, 60, 0), BodyKind::fixed)};
  const auto add = [&](const std::string& name, const Vec3& low, const Vec3& high, BodyKind kind = BodyKind::rigid) {
    list.push_back(test::box_block(name, low, high, kind));
  };
  for (int row = 0; row < rows; ++row) {
    const double y = 2 * row, gap = row == 0 ? 0.01 : 0.5;
    add("upper" + std::to_string(row), Vec3(-1, y, 0), Vec3(0, y + 1, 1));
    add("lower" + std::to_string(row), Vec3(gap, y, 0), Vec3(1 + gap, y + 1, 1),
        row == 0 ? BodyKind::fixed : BodyKind::rigid);
  }
  add("chip", Vec3(0, 0.5, 0.4), Vec3(0.01, 0.51, 0.41));
  return test::block_system(list);
}

Project sliding_rows() {
  Project project = test::rock_project(30, {{"slide", StageKind::dynamic, 0.01, 20, {}}});
  project.gravity = test::tilted_gravity(40);
  project.solver.tolerance = standard_tolerance.value;
  return project;
}

/// A step in which all fall freely but for the chip, which is held up: by nothing but a touch of both its neighbours.
class ChipLeftBehind : public testing::Test {
 protected:
  ChipLeftBehind() {
    touch(chip, 1, Vec3::UnitX());
    touch(chip, 2, -Vec3::UnitX());
    touch(3, 4, -Vec3::UnitX());
    contacts_.sort_out();
    links_.connect();
    composition_ = compose(project_, system_, 0, bodies_, links_);
    residual_.begin_stage(composition_);
    residual_.set_pattern(bodies_.nodes.movable, couplings_);
    const StepContext step = test::step_of(0.01);
    for (const auto& effect : composition_.effects) effect->begin_step(step);
    residual_.begin_step(step);
    d_ = Increment::Zero(bodies_.unknowns());
    for (const int n : bodies_.nodes.free)
      if (bodies_.nodes.body[n] != chip)
        d_.segment<3>(3 * bodies_.nodes.dof_block[n]) =
            step.integration.beta * step.length * step.length * project_.gravity;
    residual_.evaluate(d_, StepResidual::Friction::coupled);
    residual_.assemble(d_, 0, StepResidual::Friction::coupled);
  }
  void touch(int first, int second, const Vec3& normal) {
    ContactPoint point;
    point.bodies[0] = first, point.bodies[1] = second;
    point.normal = normal;
    point.size = 0.01;
    point.gap = -1e-9;
    point.normal_stiffness = point.shear_stiffness = 0.1;  // soft: next to nothing to the cubes
    point.friction = 0.5;
    point.stencil_begin = static_cast<int>(contacts_.nodes.size());
    std::vector<int> blocks, of_one;
    for (const auto& [body, weight] : {std::pair{first, 1.0}, std::pair{second, -1.0}}) {
      contacts_.nodes.push_back(bodies_.bodies[body].first_node);
      contacts_.weights.push_back(weight);
      bodies_.dof_blocks_of(contacts_.nodes.back(), of_one);
      blocks.insert(blocks.end(), of_one.begin(), of_one.end());
    }
    for (const int a : blocks)
      for (const int b : blocks) couplings_.emplace_back(a, b);
    point.stencil_end = static_cast<int>(contacts_.nodes.size());
    contacts_.points.push_back(point);
  }
  const Project project_ = sliding_rows();
  const BlockSystem system_ = rows_with_a_chip();
  BodySet bodies_{project_, system_};
  ContactSet contacts_;
  ContactLinks links_{bodies_, contacts_};
  std::vector<std::pair<int, int>> couplings_;
  Composition composition_;
  StepResidual residual_;
  NonlinearElimination elimination_{EliminationTolerances{}, {.tolerance = 1e-4, .limit = 50}};
  Increment d_;
};

TEST_F(ChipLeftBehind, IsTakenOutWithTheForcesOnItAlone) {
  const Eigen::VectorXd all = residual_.gradient();
  ASSERT_TRUE(elimination_.begin(composition_, residual_, {.most = 0.5}));
  EXPECT_TRUE(elimination_.is_active());
  residual_.evaluate(d_, StepResidual::Friction::coupled);
  EXPECT_EQ(residual_.gradient().tail(6), all.tail(6)) << "the chip is the last";
  EXPECT_GT(all.tail(6).norm(), 0.5 * bodies_.bodies[chip].mass() * project_.gravity.norm());
  EXPECT_TRUE(residual_.gradient().head(all.size() - 6).isZero(0));
  EXPECT_GT(all.head(all.size() - 6).norm(), 0) << "its neighbour is touched";

  elimination_.end(residual_);
  EXPECT_FALSE(elimination_.is_active());
  residual_.evaluate(d_, StepResidual::Friction::coupled);
  EXPECT_EQ(residual_.gradient(), all);
}

TEST_F(ChipLeftBehind, IsSolvedForWithAllOthersHeld) {
  ASSERT_TRUE(elimination_.begin(composition_, residual_, {.most = 0.5}));
  residual_.evaluate(d_, StepResidual::Friction::coupled);
  residual_.assemble(d_, 0, StepResidual::Friction::coupled);
  Eigen::VectorXd x, y;
  elimination_.solve(residual_.matrix(), residual_.unsymmetric(), residual_.gradient(), x);
  residual_.matrix().multiply(x, y);
  UnsymmetricBlocks::add_product(residual_.unsymmetric().pairs(), x, y);
  EXPECT_TRUE(x.head(x.size() - 6).isZero(0));
  EXPECT_LT((y - residual_.gradient()).tail(6).norm(), 1e-12 * residual_.gradient().norm());
}

TEST_F(ChipLeftBehind, IsNotTakenOutWhereOthersAreOutOfBalanceToo) {
  d_.setZero();
  residual_.evaluate(d_, StepResidual::Friction::coupled);
  EXPECT_FALSE(elimination_.begin(composition_, residual_, {.most = 0.5}));
  EXPECT_FALSE(elimination_.is_active());
}

TEST_F(ChipLeftBehind, IsNotTakenOutWhereItIsInBalance) {
  d_.tail(6).head(3) = d_.head(3);  // it falls, too, at the speed of its contacts' forces of nothing
  residual_.evaluate(d_, StepResidual::Friction::coupled);
  EXPECT_FALSE(elimination_.begin(composition_, residual_, {.most = 0.5}));
}

TEST_F(ChipLeftBehind, IsTakenOutWhereItIsFartherOutOfBalanceThanBefore) {
  std::vector<double> before(residual_.bodies());
  for (int b = 0; b < residual_.bodies(); ++b) before[b] = residual_.norm_of_body(b);
  EXPECT_FALSE(elimination_.begin(composition_, residual_, {.most = 0.5, .worse_than = before}));
  before.back() *= 0.9;
  ASSERT_TRUE(elimination_.begin(composition_, residual_, {.most = 0.5, .worse_than = before}));
  EXPECT_EQ(elimination_.picked().places, std::vector<int>{residual_.bodies() - 1});
}

TEST_F(ChipLeftBehind, IsTakenOutFromAmongThoseThatWereTakenOut) {
  const Increment falling = d_;
  d_.setZero();
  residual_.evaluate(d_, StepResidual::Friction::coupled);
  ASSERT_TRUE(elimination_.begin(composition_, residual_, {.most = 1}));
  ASSERT_EQ(elimination_.picked().places.size(), static_cast<std::size_t>(residual_.bodies()));
  residual_.evaluate(falling, StepResidual::Friction::coupled);
  const Eigen::VectorXd of_all = residual_.gradient();
  ASSERT_TRUE(elimination_.begin(composition_, residual_, {.most = 0.5}));
  EXPECT_EQ(elimination_.depth(), 2);
  EXPECT_EQ(elimination_.picked().places, std::vector<int>{residual_.bodies() - 1});
  residual_.evaluate(falling, StepResidual::Friction::coupled);
  EXPECT_TRUE(residual_.gradient().head(of_all.size() - 6).isZero(0));
  EXPECT_FALSE(elimination_.begin(composition_, residual_, {.most = 1})) << "it has been taken out";

  elimination_.end(residual_);
  EXPECT_EQ(elimination_.depth(), 1);
  residual_.evaluate(falling, StepResidual::Friction::coupled);
  EXPECT_EQ(residual_.gradient(), of_all);
  elimination_.end(residual_);
}

TEST_F(ChipLeftBehind, IsTakenOutWithThoseThatTouchIt) {
  const auto taken_out = [&](double most, int contacts_away) {
    EXPECT_TRUE(elimination_.begin(composition_, residual_, {.most = most, .contacts_away = contacts_away}));
    const std::vector<int> blocks = elimination_.picked().dof_blocks;
    elimination_.end(residual_);
    return blocks;
  };
  const auto [chip_begins, chip_ends] = residual_.dof_blocks_of(residual_.bodies() - 1);
  const auto [upper_begins, upper_ends] = residual_.dof_blocks_of(0);  // the slab is fixed
  const std::vector<int> alone{chip_begins, chip_begins + 1};
  const std::vector<int> with_upper{upper_begins, upper_begins + 1, chip_begins, chip_begins + 1};
  EXPECT_EQ(taken_out(0.5, 0), alone);
  EXPECT_EQ(taken_out(0.5, 1), with_upper) << "the lower one is fixed";
  EXPECT_EQ(taken_out(0.5, 2), with_upper) << "and touches others, but does not hand on what it does not feel";
  EXPECT_EQ(taken_out(1.5 / residual_.bodies(), 1), alone) << "two would be too many";
}

/// How the rows end, and in how many iterations.
struct Slide {
  std::vector<Vec3> positions;
  int iterations = 0;
};
Slide slide(const EliminationTolerances& elimination) {
  Project project = sliding_rows();
  project.solver.tolerance = reference_tolerance.value;  // so that what differs is not what steps leave out of balance
  const BlockSystem system = rows_with_a_chip();
  Tolerances tolerances;
  tolerances.solver.elimination = elimination;
  Simulation simulation(project, system, tolerances);
  Slide result;
  while (!simulation.finished()) result.iterations += simulation.step().iterations;
  result.positions = simulation.bodies().nodes.position;
  return result;
}

TEST(NonlinearElimination, LeavesTheMotionAsItIs) {
  const Slide without = slide({.most_bodies = 0, .few_bodies = 0});
  const Slide with = slide({.unbalanced = 1e-5, .most_bodies = 0.7});
  EXPECT_NE(with.iterations, without.iterations) << "bodies were taken out";
  ASSERT_EQ(with.positions.size(), without.positions.size());
  double largest = 0;
  for (std::size_t n = 0; n < with.positions.size(); ++n)
    largest = std::max(largest, (with.positions[n] - without.positions[n]).norm());
  EXPECT_LT(largest, 1e-7);
}

}  // namespace
}  // namespace talus
