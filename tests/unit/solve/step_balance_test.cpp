#include "solve/step_balance.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>

#include "support/spring_chain.hpp"

namespace talus {
namespace {

using test::chain_nodes;
using test::Load;
using test::no_contacts;
using test::SpringChain;
using Friction = StepBalance::Friction;
using Stays = SpringChain::Stays;

/// Springs, pulled at, in a step of 0.01 s.
class PulledSprings : public testing::Test {
 protected:
  PulledSprings() {
    composition.bodies = &test::no_bodies();
    composition.effects.push_back(std::make_unique<SpringChain>(Stays::through_the_stage, assembled));
  }
  void begin() {
    balance.begin_stage(composition);
    balance.set_pattern(chain_nodes, no_contacts);
    balance.begin_step(test::step_of(0.01));
  }
  Eigen::VectorXd of_springs(const Increment& at) const {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(at.size());
    composition.effects[0]->add_gradient(at, force);
    return force;
  }
  int assembled = 0;
  Composition composition;
  StepBalance balance;
  const Increment d = Increment::LinSpaced(3 * chain_nodes, -1, 3);
  const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(3 * chain_nodes, 1, 2);
};

TEST(StepBalance, what_stays_the_same_through_a_stage_is_assembled_when_length_integration_or_pattern_change) {
  int constant = 0, of_step = 0;
  Composition composition;
  composition.effects.push_back(std::make_unique<SpringChain>(Stays::through_the_stage, constant));
  composition.effects.push_back(std::make_unique<SpringChain>(Stays::through_the_step, of_step));
  StepBalance balance;
  balance.begin_stage(composition);
  balance.set_pattern(chain_nodes, no_contacts);
  StepContext step = test::step_of(0.01);
  EXPECT_TRUE(balance.begin_step(step)) << "the first of its kind";
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(balance.begin_step(step));
  EXPECT_EQ(constant, 1);
  EXPECT_EQ(of_step, 5);
  step.length = 0.02;
  EXPECT_TRUE(balance.begin_step(step));
  EXPECT_FALSE(balance.begin_step(step));
  EXPECT_EQ(constant, 2);
  step.integration = TimeIntegration::generalized_alpha(0.5);
  EXPECT_TRUE(balance.begin_step(step));
  EXPECT_FALSE(balance.begin_step(step));
  EXPECT_EQ(constant, 3);
  balance.set_pattern(chain_nodes, {{0, 5}});
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(balance.begin_step(step)) << "a factor of the other pattern is gone anyway";
  EXPECT_EQ(constant, 4);
  balance.end_stage();
  balance.begin_stage(composition);
  EXPECT_TRUE(balance.begin_step(step));
  EXPECT_EQ(constant, 5);
}

TEST_F(PulledSprings, leave_the_sum_of_their_forces_and_say_the_share_of_each) {
  composition.effects.push_back(std::make_unique<Load>());
  begin();
  balance.evaluate(d, Friction::coupled);
  EXPECT_LT((balance.gradient() - (of_springs(d) - load)).norm(), 1e-14 * load.norm());
  EXPECT_EQ(balance.residual(), balance.gradient().norm());
  EXPECT_DOUBLE_EQ(balance.works()[0], of_springs(d).dot(d));
  EXPECT_DOUBLE_EQ(balance.works()[1], -load.dot(d));
  EXPECT_DOUBLE_EQ(balance.force_scale(), std::max(of_springs(d).norm(), load.norm()));
  EXPECT_EQ(balance.imbalance(), 0) << "nothing moves";
}

TEST_F(PulledSprings, have_the_derivative_of_that_for_a_matrix) {
  composition.effects.push_back(std::make_unique<Load>());
  begin();
  balance.assemble(d, 0);
  Eigen::VectorXd changed;
  balance.matrix().multiply(load, changed);
  balance.evaluate(d, Friction::coupled);
  const Eigen::VectorXd before = balance.gradient();
  balance.evaluate(d + load, Friction::coupled);
  EXPECT_LT((balance.gradient() - before - changed).norm(), 1e-13 * changed.norm());
}

TEST_F(PulledSprings, are_counted) {
  composition.effects.push_back(std::make_unique<Load>());
  begin();
  for (int i = 0; i < 3; ++i) balance.evaluate(d, Friction::coupled);
  balance.end_stage();
  begin();
  balance.evaluate(d, Friction::coupled);
  const auto work = balance.effect_work();
  EXPECT_EQ(work.at("springs").built, 2);
  EXPECT_EQ(work.at("springs").assemblies, 2);
  EXPECT_EQ(work.at("springs").evaluations, 4);
  EXPECT_EQ(work.at("load").evaluations, 4);
}

TEST_F(PulledSprings, are_the_rest_beside_contacts) {
  composition.effects.push_back(std::make_unique<Load>(EnergyAccount::contact));
  begin();
  Eigen::VectorXd sum = load;
  balance.add_gradient_of_rest(d, sum);
  EXPECT_LT((sum - load - of_springs(d)).norm(), 1e-14 * sum.norm());
}

TEST_F(PulledSprings, are_measured_against_inertia_and_looked_at_without_it) {
  composition.effects.push_back(std::make_unique<Load>(EnergyAccount::kinetic));
  begin();
  balance.evaluate(d, Friction::coupled);
  EXPECT_DOUBLE_EQ(balance.imbalance(), load.norm() / of_springs(d).norm());
  balance.evaluate_without_inertia();
  EXPECT_EQ(balance.residual(), 0) << "springs that nothing has stretched";
}

TEST_F(PulledSprings, go_no_further_at_once_than_contacts_were_sought) {
  begin();
  StepContext step = test::step_of(0.01);
  step.reach = 0.5;
  balance.begin_step(step);
  Eigen::VectorXd change = Eigen::VectorXd::Zero(d.size());
  change.segment<3>(6) = Vec3(0, 1.2, -1.6);
  EXPECT_DOUBLE_EQ(balance.longest_share(d, change), 0.25);
  EXPECT_EQ(balance.longest_share(d, 0.1 * change), 1);
}

}  // namespace
}  // namespace talus
