#include "solve/equilibrium/step_residual.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "effects/compose.hpp"
#include "mesh/structured_mesh.hpp"
#include "support/solver_scenes.hpp"
#include "support/spring_chain.hpp"

namespace talus {
namespace {

using test::chain_nodes;
using test::Load;
using test::no_contacts;
using test::SpringChain;
using Friction = StepResidual::Friction;
using Stays = SpringChain::Stays;

/// Springs, pulled at, in a step of 0.01 s.
class PulledSprings : public testing::Test {
 protected:
  PulledSprings() {
    composition.bodies = &body;
    composition.effects.push_back(std::make_unique<SpringChain>(Stays::through_the_stage, assembled));
  }
  void begin() {
    residual.begin_stage(composition);
    residual.set_pattern(chain_nodes, no_contacts);
    residual.begin_step(test::step_of(0.01));
  }
  Eigen::VectorXd of_springs(const Increment& at) const {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(at.size());
    composition.effects[0]->add_gradient(at, Arms::end, force);
    return force;
  }
  int assembled = 0;
  BodySet body = test::chain_body();
  Composition composition;
  StepResidual residual;
  const Increment d = Increment::LinSpaced(3 * chain_nodes, -1, 3);
  const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(3 * chain_nodes, 1, 2);
};

TEST(StepResidual, AssemblesConstantPartsWhenLengthIntegrationOrPatternChange) {
  int constant = 0, of_step = 0;
  Composition composition;
  BodySet body = test::chain_body();
  composition.bodies = &body;
  composition.effects.push_back(std::make_unique<SpringChain>(Stays::through_the_stage, constant));
  composition.effects.push_back(std::make_unique<SpringChain>(Stays::through_the_step, of_step));
  StepResidual residual;
  residual.begin_stage(composition);
  residual.set_pattern(chain_nodes, no_contacts);
  StepContext step = test::step_of(0.01);
  EXPECT_TRUE(residual.begin_step(step)) << "the first of its kind";
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(residual.begin_step(step));
  EXPECT_EQ(constant, 1);
  EXPECT_EQ(of_step, 5);
  step.length = 0.02;
  EXPECT_TRUE(residual.begin_step(step));
  EXPECT_FALSE(residual.begin_step(step));
  EXPECT_EQ(constant, 2);
  step.integration = TimeIntegration::generalized_alpha(0.5);
  EXPECT_TRUE(residual.begin_step(step));
  EXPECT_FALSE(residual.begin_step(step));
  EXPECT_EQ(constant, 3);
  residual.set_pattern(chain_nodes, {{0, 5}});
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(residual.begin_step(step)) << "a factor of the other pattern is gone anyway";
  EXPECT_EQ(constant, 4);
  residual.end_stage();
  residual.begin_stage(composition);
  EXPECT_TRUE(residual.begin_step(step));
  EXPECT_EQ(constant, 5);
}

TEST_F(PulledSprings, SumToTheResidualAndTellTheWorkOfEach) {
  composition.effects.push_back(std::make_unique<Load>());
  begin();
  residual.evaluate(d, Friction::coupled);
  EXPECT_LT((residual.gradient() - (of_springs(d) - load)).norm(), 1e-14 * load.norm());
  EXPECT_EQ(residual.norm(), residual.gradient().norm());
  EXPECT_DOUBLE_EQ(residual.works()[0], of_springs(d).dot(d));
  EXPECT_DOUBLE_EQ(residual.works()[1], -load.dot(d));
  EXPECT_DOUBLE_EQ(residual.force_scale(), std::max(of_springs(d).norm(), load.norm()));
  EXPECT_EQ(residual.static_residual(), 0) << "nothing moves";
}

TEST_F(PulledSprings, HaveTheDerivativeOfTheGradientForAMatrix) {
  composition.effects.push_back(std::make_unique<Load>());
  begin();
  residual.assemble(d, 0, Friction::frozen);
  Eigen::VectorXd changed;
  residual.matrix().multiply(load, changed);
  residual.evaluate(d, Friction::coupled);
  const Eigen::VectorXd before = residual.gradient();
  residual.evaluate(d + load, Friction::coupled);
  EXPECT_LT((residual.gradient() - before - changed).norm(), 1e-13 * changed.norm());
}

/// Notes the arms that it is asked for, and pulls where they are the mean ones.
class ArmsAskedFor final : public Effect {
 public:
  explicit ArmsAskedFor(std::vector<Arms>& asked) : asked_(asked) {}
  EffectKind kind() const override { return EffectKind::point_load; }
  EnergyAccount account() const override { return EnergyAccount::potential; }
  double energy(const Increment&) const override { return 0; }
  void add_gradient(const Increment&, Arms arms, Eigen::VectorXd& sum) const override {
    asked_.push_back(arms);
    if (arms == Arms::mean) sum.array() += 2;
  }

 private:
  std::vector<Arms>& asked_;
};

TEST_F(PulledSprings, KeepWhatMeanArmsAddWhileFrictionIsFrozen) {
  std::vector<Arms> asked;
  composition.effects.push_back(std::make_unique<ArmsAskedFor>(asked));
  begin();
  StepContext step = test::step_of(0.01);
  step.arms = Arms::mean;
  residual.begin_step(step);
  residual.evaluate(d, Friction::coupled);
  const Eigen::VectorXd coupled = residual.gradient();
  residual.freeze(d);
  EXPECT_NEAR(residual.norm_of_system(0), coupled.norm(), 1e-13 * coupled.norm()) << "nothing was balanced by that";
  residual.evaluate(d, Friction::frozen);
  EXPECT_THAT(asked, testing::ElementsAre(Arms::mean, Arms::end, Arms::end));
  EXPECT_LT((residual.gradient() - coupled).norm(), 1e-14 * coupled.norm()) << "where it was frozen nothing changes";
  residual.evaluate(d + load, Friction::frozen);
  EXPECT_LT((residual.gradient() - coupled - of_springs(load)).norm(), 1e-13 * coupled.norm());
  step.arms = Arms::end;
  residual.begin_step(step);
  residual.evaluate(d, Friction::coupled);
  residual.freeze(d);
  residual.evaluate(d, Friction::frozen);
  EXPECT_LT((residual.gradient() - of_springs(d)).norm(), 1e-14 * coupled.norm()) << "nothing is frozen";
}

TEST_F(PulledSprings, AreCounted) {
  composition.effects.push_back(std::make_unique<Load>());
  begin();
  for (int i = 0; i < 3; ++i) residual.evaluate(d, Friction::coupled);
  residual.end_stage();
  begin();
  residual.evaluate(d, Friction::coupled);
  const auto work = residual.effect_work();
  EXPECT_EQ(work.at(EffectKind::elasticity).built, 2);
  EXPECT_EQ(work.at(EffectKind::elasticity).assemblies, 2);
  EXPECT_EQ(work.at(EffectKind::elasticity).evaluations, 4);
  EXPECT_EQ(work.at(EffectKind::point_load).evaluations, 4);
}

TEST_F(PulledSprings, RemainWithoutContacts) {
  composition.effects.push_back(std::make_unique<Load>(EnergyAccount::contact));
  begin();
  Eigen::VectorXd sum = load;
  residual.add_gradient_without_contacts(d, sum);
  EXPECT_LT((sum - load - of_springs(d)).norm(), 1e-14 * sum.norm());
}

TEST_F(PulledSprings, AreComparedWithInertiaAndEvaluatedWithoutIt) {
  composition.effects.push_back(std::make_unique<Load>(EnergyAccount::kinetic));
  begin();
  residual.evaluate(d, Friction::coupled);
  EXPECT_DOUBLE_EQ(residual.static_residual(), load.norm() / of_springs(d).norm());
  residual.evaluate_without_inertia();
  EXPECT_EQ(residual.norm(), 0) << "springs that nothing has stretched";
}

/// Two cubes that fall side by side, in a step in which contacts were sought up to 0.5 m.
class FallingCubes : public testing::Test {
 protected:
  FallingCubes() {
    residual_.begin_stage(composition_);
    residual_.set_pattern(bodies_.nodes.movable, no_contacts);
    StepContext step = test::step_of(0.01);
    step.reach = 0.5;
    residual_.begin_step(step);
    first_ = 3 * (residual_.dof_blocks_of(0).second - residual_.dof_blocks_of(0).first);
    change_.segment<3>(3) = Vec3(0, 1.2, -1.6);
  }
  static Block cube_at(double x) {
    Block block;
    block.mesh = box_mesh(Vec3(x, 0, 0), Vec3(x + 1, 1, 1), 1, 1, 1);
    block.surface = boundary(block.mesh);
    return block;
  }

  const Project project_ = test::rock_project(30, {{"fall", StageKind::dynamic, 0.01, 1, {}}});
  const BlockSystem system_ = test::block_system({cube_at(0), cube_at(3)});
  BodySet bodies_{project_, system_};
  const ContactSet contacts_;
  const ContactLinks links_{bodies_, contacts_};
  Composition composition_ = compose(project_, system_, 0, bodies_, links_);
  StepResidual residual_;
  Eigen::VectorXd change_ = Eigen::VectorXd::Constant(bodies_.unknowns(), 0.01);  // one node of the first goes 2 m
  Eigen::Index first_ = 0;                                                        // unknowns of the first
};

TEST_F(FallingCubes, GoNoFurtherAtOnceThanContactsWereSought) {
  const Increment rest = Increment::Zero(bodies_.unknowns());
  EXPECT_DOUBLE_EQ(residual_.longest_step_fraction(rest, change_), 0.25);
  EXPECT_EQ(residual_.longest_step_fraction(rest, 0.1 * change_), 1);
}

TEST_F(FallingCubes, OfWhichOneGoesFartherAreHeldBackEachByItself) {
  const Eigen::VectorXd before = change_;
  residual_.keep_within_reach(change_);
  EXPECT_EQ(change_.head(first_), 0.25 * before.head(first_));
  EXPECT_EQ(change_.tail(change_.size() - first_), before.tail(change_.size() - first_));
}

TEST_F(FallingCubes, ThatShareNoContactAreIndependentSystemsWithNormsAndScalesOfTheirOwn) {
  const StepContext step = test::step_of(0.01);
  for (const auto& effect : composition_.effects) effect->begin_step(step);
  residual_.begin_step(step);
  ASSERT_EQ(residual_.systems(), 2);
  EXPECT_EQ(residual_.system_of(0), 0);
  EXPECT_EQ(residual_.system_of(static_cast<int>(first_ / 3)), 1);
  Increment d = Increment::Zero(bodies_.unknowns());
  residual_.evaluate(d, Friction::coupled);
  EXPECT_GT(residual_.norm_of_system(0), 0) << "its weight";
  const double norm = residual_.norm_of_system(1), scale = residual_.force_scale_of_system(1);
  EXPECT_NEAR(std::hypot(residual_.norm_of_system(0), norm), residual_.norm(), 1e-12 * residual_.norm());
  d[0] = 0.1;
  residual_.evaluate(d, Friction::coupled);
  EXPECT_GT(residual_.norm_of_system(0), 10 * norm) << "a corner of the first was pulled";
  EXPECT_GT(residual_.force_scale_of_system(0), 10 * scale);
  EXPECT_EQ(residual_.norm_of_system(1), norm);
  EXPECT_EQ(residual_.force_scale_of_system(1), scale);
}

}  // namespace
}  // namespace talus
