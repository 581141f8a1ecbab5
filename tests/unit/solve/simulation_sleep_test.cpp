// Blocks that fall asleep in a run and what wakes them. That detection finds the same beside sleepers as without them,
// to the last bit, is held by tests/unit/contact/sleep_test.cpp.
#include <gmock/gmock.h>

#include <algorithm>

#include "bodies/block_motion.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

Stage settling(int steps) { return {"settle", StageKind::static_, 0.01, steps, {}}; }
Stage moving(int steps, double time_step = 0.01) { return {"move", StageKind::dynamic, time_step, steps, {}}; }

/// The scene, run: what it did step by step, and how it ended.
struct Outcome {
  std::vector<StepReport> steps;
  std::vector<BlockMotion> blocks;
  EnergyLedger energy;
  RunWork work;
  int most_asleep() const {
    int most = 0;
    for (const StepReport& step : steps) most = std::max(most, step.asleep);
    return most;
  }
  double largest_energy() const {
    double largest = 0;
    for (const StepReport& step : steps)
      for (const double e : {step.energy.kinetic, step.energy.elastic, step.energy.potential, step.energy.contact,
                             step.energy.friction_dissipated, step.energy.constraint_work})
        largest = std::max(largest, std::abs(e));
    return largest;
  }
};

Outcome outcome_of(const Project& project, const BlockSystem& system) {
  Simulation simulation(project, system);
  Outcome outcome;
  while (!simulation.finished()) outcome.steps.push_back(simulation.step());
  EXPECT_TRUE(simulation.converged()) << simulation.failure();
  for (int b = 0; b < static_cast<int>(system.blocks.size()); ++b)
    outcome.blocks.push_back(block_motion(simulation.bodies(), b));
  outcome.energy = outcome.steps.back().energy;
  outcome.work = simulation.work();
  return outcome;
}

Outcome awake(Project project, const BlockSystem& system) {
  project.solver.sleep_tolerance = 0;
  Outcome outcome = outcome_of(project, system);
  EXPECT_EQ(outcome.most_asleep(), 0);
  return outcome;
}

double difference(const BlockMotion& a, const BlockMotion& b) { return (a.displacement - b.displacement).norm(); }

TEST(SimulationSleep, RestingBlockFallsAsleepInADynamicStageAndNotInAStaticOne) {
  Project project = test::rock_project(35, {settling(100), moving(60)});
  project.gravity = test::tilted_gravity(30);
  const Outcome outcome = outcome_of(project, test::cube_on_slab());
  for (int i = 0; i < 160; ++i) EXPECT_EQ(outcome.steps[i].asleep, i < 119 ? 0 : 1) << "after step " << i + 1;
  EXPECT_EQ(outcome.work.block_steps_asleep, std::count_if(outcome.steps.begin(), outcome.steps.end(),
                                                           [](const StepReport& step) { return step.asleep == 1; }));
  EXPECT_EQ(outcome.steps.back().iterations, 0);
  EXPECT_EQ(outcome.steps.back().contacts, 0);
}

TEST(SimulationSleep, NoBlockSleepsThatFliesSlidesBearsAChangingLoadOrStandsOnAMovingBase) {
  const BlockSystem system = test::cube_on_slab();
  Project thrown = test::rock_project(30, {moving(400, 1e-3)});
  thrown.velocities = {{"B", Vec3(0, 0, 2), Vec3::Zero()}};  // back on the ground after 0.408 s
  EXPECT_EQ(outcome_of(thrown, system).most_asleep(), 0);

  Project sliding = test::rock_project(29.9, {moving(100)});
  sliding.gravity = test::tilted_gravity(30);
  EXPECT_EQ(outcome_of(sliding, system).most_asleep(), 0);

  Project loaded = test::rock_project(30, {settling(50), moving(100)});
  loaded.loads = {{"B", Vec3(0.5, 0.5, 0.5), Vec3::Zero(), {{0, Vec3::Zero()}, {100, Vec3(1e-3, 0, 0)}}}};
  EXPECT_EQ(outcome_of(loaded, system).most_asleep(), 0);

  Project shaken = test::rock_project(30, {settling(50), moving(100)});
  shaken.constraints = {{"ground", {}, {0, 0, 0}, {{1, Vec3::Zero()}, {1e3, Vec3(1e-12, 0, 0)}}}};
  EXPECT_EQ(outcome_of(shaken, system).most_asleep(), 0);
}

/// Two blocks on top of each other, and one that falls on them from `height` after they have fallen asleep.
BlockSystem pile_and_falling_block(double height, BodyKind body = BodyKind::tetrahedra) {
  return test::block_system({test::box_block("ground", Vec3(-5, -5, -1), Vec3(5, 5, 0), BodyKind::fixed),
                             test::box_block("lower", Vec3(0, 0, 0), Vec3(1, 1, 1), body),
                             test::box_block("upper", Vec3(0, 0, 1), Vec3(1, 1, 2), body),
                             test::box_block("falling", Vec3(0.2, 0.1, 2 + height), Vec3(1.2, 1.1, 3 + height), body)});
}

Project pile_project(int steps) {
  Stage wait = settling(100), fall = moving(steps);
  wait.blocks = {{"falling", BodyKind::fixed}};
  fall.blocks = {{"falling", BodyKind::tetrahedra}};
  return test::rock_project(30, {wait, fall});
}

TEST(SimulationSleep, PileWakesAsOneInTheStepInWhichAFallingBlockTouchesIt) {
  const Project project = pile_project(100);
  const BlockSystem system = pile_and_falling_block(2);
  Simulation simulation(project, system);
  while (!simulation.stage_ended()) simulation.step();
  bool slept = false;
  int before = 0;
  for (int woken = -1; woken != 2;) {
    before = simulation.step().asleep;
    slept = slept || before == 2;
    ASSERT_FALSE(simulation.finished()) << "nobody woke";
    ASSERT_TRUE(before == 0 || before == 2) << "half a pile sleeps";
    woken = static_cast<int>(simulation.work().wakings);
  }
  EXPECT_TRUE(slept);
  EXPECT_EQ(before, 0);
  EXPECT_LT(block_motion(simulation.bodies(), 3).displacement.z(), -1);
  const auto touches = [](const ContactSample& contact) {
    return (contact.blocks[0] == 3 || contact.blocks[1] == 3) && contact.state != ContactState::open;
  };
  EXPECT_TRUE(std::ranges::any_of(simulation.contacts(), touches));
}

/// A row of cubes on the ground, and one that slides past the last of them.
BlockSystem row_and_slider(BodyKind body) {
  std::vector<Block> blocks{test::box_block("ground", Vec3(-5, -5, -1), Vec3(20, 5, 0), BodyKind::fixed)};
  for (int i = 0; i < 4; ++i)
    blocks.push_back(test::box_block("row " + std::to_string(i), Vec3(i, 0, 0), Vec3(i + 1, 1, 1), body));
  blocks.push_back(test::box_block("slider", Vec3(3, 1.001, 0), Vec3(4, 2.001, 1), body));
  return test::block_system(blocks);
}

TEST(SimulationSleep, BlocksSleepThatAreNotBesideOneThatMoves) {
  for (const BodyKind body : {BodyKind::rigid, BodyKind::affine}) {
    Project project = test::rock_project(30, {settling(50), moving(60)});
    project.velocities = {{"slider", Vec3(3, 0, 0), Vec3::Zero()}};
    const BlockSystem system = row_and_slider(body);
    const Outcome slept = outcome_of(project, system), never = awake(project, system);
    EXPECT_EQ(slept.steps[75].asleep, 3) << "the slider is beside the last of the row";
    for (int b = 1; b <= 5; ++b) EXPECT_LT(difference(slept.blocks[b], never.blocks[b]), 1e-6) << b;
    EXPECT_LT(std::abs(slept.energy.remainder), 1e-9 * slept.largest_energy());
  }
}

TEST(SimulationSleep, SleepersThatLoseWhatTheyLeanOnGoAsThoseThatNeverSlept) {
  // The second leans on the first, the first on a stop that a load holds and then lifts away: the second may sleep.
  const BlockSystem system =
      test::block_system({test::box_block("ground", Vec3(-9, -5, -1), Vec3(20, 5, 0), BodyKind::fixed),
                          test::box_block("stop", Vec3(-0.3, 0, 0), Vec3(0, 1, 1), BodyKind::rigid),
                          test::box_block("first", Vec3(0, 0, 0), Vec3(1, 1, 1), BodyKind::rigid),
                          test::box_block("second", Vec3(1, 0, 0), Vec3(2, 1, 1), BodyKind::rigid)});
  Project project = test::rock_project(20, {moving(220)});
  project.gravity = Vec3(-5, 0, -9.81);
  project.loads = {{"stop",
                    Vec3(-0.15, 0.5, 0.5),
                    Vec3::Zero(),
                    {{0, Vec3(5e4, 0, 0)}, {1, Vec3(5e4, 0, 0)}, {1.2, Vec3(0, 0, 4e4)}, {9, Vec3(0, 0, 4e4)}}}};
  const Outcome slept = outcome_of(project, system), never = awake(project, system);
  EXPECT_GE(slept.most_asleep(), 1);
  EXPECT_EQ(slept.steps.back().asleep, 0);
  EXPECT_LT(slept.blocks[2].displacement.x(), -0.1);
  for (int b = 1; b <= 3; ++b) EXPECT_LT(difference(slept.blocks[b], never.blocks[b]), 1e-3) << b;
}

TEST(SimulationSleep, HitOnSleepersGoesAsOneOnThoseThatNeverSlept) {
  const BlockSystem system = pile_and_falling_block(2);
  for (const int steps : {60, 100}) {  // before and after the impact at 0.64 s
    const Outcome slept = outcome_of(pile_project(steps), system), never = awake(pile_project(steps), system);
    EXPECT_EQ(slept.most_asleep(), 2);
    const double tolerance = 1e-9 * 0.01 * steps;
    for (int b = 1; b <= 3; ++b) EXPECT_LT(difference(slept.blocks[b], never.blocks[b]), tolerance) << b;
  }
}

/// Heaps of three cubes that turn as they fall on each other.
constexpr int heaps = 6, in_heap = 3;
BlockSystem heaps_that_fall() {
  std::vector<Block> blocks{test::box_block("ground", Vec3(-30, -9, -1), Vec3(30, 9, 0), BodyKind::fixed)};
  for (int i = 0; i < heaps * in_heap; ++i) {
    const Vec3 at(8.0 * (i / in_heap) - 20 + 0.2 * (i % in_heap), 0.15 * (i % in_heap),
                  0.3 + (1.2 + 0.1 * i) * (i % in_heap));
    blocks.push_back(test::box_block("B" + std::to_string(i), at, at + Vec3::Ones(), BodyKind::rigid));
  }
  return test::block_system(blocks);
}

TEST(SimulationSleep, SpringsHoldNoEnergyLessThanNoneWhileSomeFallAsleep) {
  Project project = test::rock_project(30, {moving(1000, 5e-3)});
  for (int i = 0; i < heaps * in_heap; ++i)
    project.velocities.push_back({"B" + std::to_string(i), Vec3::Zero(), Vec3(0.4 + 0.1 * i, 1.1 - 0.1 * i, 0.2)});
  const Outcome outcome = outcome_of(project, heaps_that_fall());
  EXPECT_EQ(outcome.most_asleep(), heaps * in_heap);
  double least = 0;
  for (const StepReport& step : outcome.steps) least = std::min(least, step.energy.contact);
  EXPECT_GT(least, -1e-9 * outcome.largest_energy());
}

TEST(SimulationSleep, NewStageWakesAllAndAJointThatLosesItsStrengthLetsItsBlockGo) {
  Stage slide = moving(50);
  slide.joints = {{"J", 10.0, {}, {}, {}}};
  Project project = test::rock_project(35, {settling(100), moving(50), slide});
  project.gravity = test::tilted_gravity(30);
  const BlockSystem system = test::cube_on_slab();
  const Outcome slept = outcome_of(project, system), never = awake(project, system);
  EXPECT_EQ(slept.steps[149].asleep, 1);
  for (int i = 150; i < 200; ++i) EXPECT_EQ(slept.steps[i].asleep, 0);
  EXPECT_GT(slept.blocks[1].displacement.x(), 0.1);
  EXPECT_LT(difference(slept.blocks[1], never.blocks[1]), 1e-9);
}

TEST(SimulationSleep, LedgerClosesThroughFallingAsleepWakingAndStages) {
  for (const BodyKind body : {BodyKind::tetrahedra, BodyKind::affine, BodyKind::rigid}) {
    Project project = pile_project(100);
    project.stages[1].blocks[0].body = body;
    project.stages.push_back(moving(50));
    project.stages.back().name = "after";
    project.stages.back().damping = 0.5;
    project.stages[0].damping = 0;
    project.solver.tolerance = reference_tolerance.value;  // so that what differs is what sleep makes
    const BlockSystem system = pile_and_falling_block(2, body);
    const Outcome slept = outcome_of(project, system), never = awake(project, system);
    EXPECT_GE(slept.most_asleep(), 2);
    const double most = slept.largest_energy();
    for (const StepReport& step : slept.steps) EXPECT_LT(std::abs(step.energy.remainder), 1e-8 * most) << step.step;
    EXPECT_NEAR(slept.energy.elastic, never.energy.elastic, 1e-6 * most);
    EXPECT_NEAR(slept.energy.contact, never.energy.contact, 1e-6 * most);
    EXPECT_NEAR(slept.energy.potential, never.energy.potential, 1e-6 * most);
    EXPECT_NEAR(slept.energy.kinetic, never.energy.kinetic, 1e-6 * most);
  }
}

TEST(SimulationSleep, StageThatBeginsWithSleepersCountsTheirEnergyOnce) {
  Project project = test::rock_project(35, {settling(100), moving(50), moving(5), moving(50)});
  project.gravity = test::tilted_gravity(30);
  const BlockSystem system = test::cube_on_slab();
  const Outcome slept = outcome_of(project, system), never = awake(project, system);
  EXPECT_EQ(slept.steps[149].asleep, 1);
  EXPECT_EQ(slept.steps[150].asleep, 0);
  for (const std::size_t step : {149, 150, 154, 204}) {
    const EnergyLedger &with = slept.steps[step].energy, &without = never.steps[step].energy;
    EXPECT_NEAR(with.elastic / without.elastic, 1, 1e-6) << step;
    EXPECT_NEAR(with.contact / without.contact, 1, 1e-6) << step;
    EXPECT_NEAR(with.potential / without.potential, 1, 1e-6) << step;
    EXPECT_NEAR(with.integration_loss, without.integration_loss, 1e-6 * std::abs(with.potential)) << step;
  }
}

/// What all asleep look like.
struct AsleepCase {
  BodyKind body;
  Strain strain;
};

class AllAsleep : public testing::TestWithParam<AsleepCase> {
 protected:
  AllAsleep() {
    project.gravity = test::tilted_gravity(20);
    project.solver.strain = GetParam().strain;
    project.in_situ.emplace_back();
    project.in_situ[0].stress << 0, 0, -5e4, 0, 0, 0;
    project.monitors = {{"P", "B", Vec3(0.5, 0.5, 0.5), GetParam().body != BodyKind::rigid}};
  }
  Project project = test::rock_project(35, {settling(150), moving(100)});
  BlockSystem system = test::block_system({test::box_block("ground", Vec3(-5, -5, -1), Vec3(20, 5, 0), BodyKind::fixed),
                                           test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1), GetParam().body)});
};

TEST_P(AllAsleep, StepsGoOnAndFramesAndMonitorsStayAsTheyWere) {
  Simulation simulation(project, system);
  StepReport report;
  while (report.asleep == 0) {
    ASSERT_FALSE(simulation.finished()) << "did not fall asleep";
    report = simulation.step();
  }
  const double fell_asleep = simulation.time();
  const Frame before = simulation.frame(0);
  const HistoryRow row_before = simulation.history();
  while (!simulation.finished()) report = simulation.step();
  ASSERT_TRUE(simulation.converged());
  EXPECT_NEAR(simulation.time(), 2.5, 1e-12);
  EXPECT_GT(simulation.time(), fell_asleep);
  const Frame after = simulation.frame(1);
  const HistoryRow row = simulation.history();
  EXPECT_EQ(after.displacement, before.displacement);
  for (const Vec3& velocity : after.velocity) EXPECT_EQ(velocity, Vec3::Zero());
  EXPECT_EQ(after.stress, before.stress);
  EXPECT_EQ(row.monitors[0].displacement, row_before.monitors[0].displacement);
  EXPECT_EQ(row.monitors[0].velocity, Vec3::Zero());
  EXPECT_EQ(row.monitors[0].stress, row_before.monitors[0].stress);
}

TEST_P(AllAsleep, FramesShowWhatOneWithoutSleepDoes) {
  const auto end = [&](double sleep_tolerance) {
    project.solver.sleep_tolerance = sleep_tolerance;
    Simulation simulation(project, system);
    while (!simulation.finished()) simulation.step();
    EXPECT_EQ(simulation.work().block_steps_asleep > 0, sleep_tolerance > 0);
    return simulation.frame(0);
  };
  const Frame slept = end(1e-9), never = end(0);
  for (std::size_t n = 0; n < slept.displacement.size(); ++n)
    EXPECT_LT((slept.displacement[n] - never.displacement[n]).norm(), 1e-9);
  double stress = 0;
  for (const Voigt& s : never.stress) stress = std::max(stress, s.norm());
  for (std::size_t t = 0; t < slept.stress.size(); ++t) EXPECT_LT((slept.stress[t] - never.stress[t]).norm(), 10);
  EXPECT_EQ(stress > 0, GetParam().body != BodyKind::rigid);
  ASSERT_EQ(slept.contacts.size(), never.contacts.size());
  ASSERT_GT(slept.contacts.size(), 0u);
  Vec3 force = Vec3::Zero();
  for (std::size_t i = 0; i < slept.contacts.size(); ++i) {
    const ContactSample &with = slept.contacts[i], &without = never.contacts[i];
    EXPECT_EQ(with.state, ContactState::stick);
    EXPECT_NEAR(with.normal_force, without.normal_force, 1e-5 * 2600 * 9.81);
    EXPECT_LT((with.shear_force - without.shear_force).norm(), 1e-5 * 2600 * 9.81);
    EXPECT_LT((with.position - without.position).norm(), 1e-9);
    force += with.normal_force * with.normal + with.shear_force;
  }
  EXPECT_LT((force * (slept.contacts[0].blocks[0] == 1 ? 1 : -1) + 2600 * project.gravity).norm(), 1e-4 * 2600 * 9.81);
}

constexpr AsleepCase kinds[] = {{BodyKind::tetrahedra, Strain::corotational},
                                {BodyKind::tetrahedra, Strain::incremental},
                                {BodyKind::affine, Strain::corotational},
                                {BodyKind::affine, Strain::incremental},
                                {BodyKind::rigid, Strain::corotational}};
INSTANTIATE_TEST_SUITE_P(Bodies, AllAsleep, testing::ValuesIn(kinds));

TEST(SimulationSleep, FlyingBlockCostsTheSameWorkBesideSleepersAsAlone) {
  const auto work_of_last_steps = [](int sleepers) {
    Project project = test::rock_project(30, {settling(60), moving(100)});
    // A step that begins within the tolerance takes no iteration: at standard it is chance which ones do, and at
    // reference one in fifty may take one more, by where the origin is.
    project.solver.tolerance = reference_tolerance.value;
    project.stages[0].blocks = {{"falling", BodyKind::fixed}};
    project.stages[1].blocks = {{"falling", BodyKind::tetrahedra}};
    BlockSystem system =
        test::block_system({test::box_block("ground", Vec3(-5, -5, -1), Vec3(60, 60, 0), BodyKind::fixed),
                            test::box_block("falling", Vec3(-2, 0, 8), Vec3(-1, 1, 9))});
    for (int i = 0; i < sleepers; ++i) {
      const Vec3 corner(2.0 * (i % 5), 3.0 * (i / 5), 0);
      system.blocks.push_back(test::box_block("S" + std::to_string(i), corner, corner + Vec3::Ones()));
    }
    Simulation simulation(project, system);
    while (simulation.time() < 1) simulation.step();
    const RunWork begin = simulation.work();
    const auto evaluations = [&] {
      long sum = 0;
      for (const EffectOutcome& effect : simulation.effects()) sum += effect.evaluations + effect.assemblies;
      return sum;
    };
    const long evaluated = evaluations();
    StepReport report;
    while (simulation.time() < 1.5) report = simulation.step();
    EXPECT_EQ(report.asleep, sleepers);
    const RunWork end = simulation.work();
    return std::array{end.contact_points - begin.contact_points,
                      end.facet_pairs - begin.facet_pairs,
                      end.body_pairs - begin.body_pairs,
                      end.linear_solves - begin.linear_solves,
                      end.dense_factorisations - begin.dense_factorisations,
                      end.factorisations - begin.factorisations,
                      static_cast<long>(end.systems),
                      evaluations() - evaluated};
  };
  const auto alone = work_of_last_steps(0), beside = work_of_last_steps(20);
  for (std::size_t k = 0; k < alone.size(); ++k) EXPECT_NEAR(beside[k], alone[k], 0.05 * double(alone[k])) << k;
  EXPECT_GT(alone.back(), 0);
}

}  // namespace
}  // namespace talus
