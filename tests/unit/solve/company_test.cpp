// Who can touch nobody pays for no contact, and is found in company before it touches somebody.
#include "solve/company.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <span>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

constexpr double far_away = 5000;  // m

Block rigid_cube(const std::string& name, const Vec3& corner) {
  return test::box_block(name, corner, corner + Vec3::Ones(), BodyKind::rigid);
}

Block slab() { return test::box_block("ground", Vec3(-5, -5, -1), Vec3(20, 5, 0), BodyKind::fixed); }

Stage stage_of(int steps, double length = 0.01) { return {"move", StageKind::dynamic, length, steps, {}}; }

const EffectOutcome& effect_called(const std::vector<EffectOutcome>& effects, const std::string& name) {
  return *std::find_if(effects.begin(), effects.end(), [&](const auto& e) { return e.name == name; });
}

std::vector<Vec3> positions_after(const Project& project, const BlockSystem& system) {
  Simulation simulation(project, system);
  while (!simulation.finished()) simulation.step();
  EXPECT_TRUE(simulation.converged()) << simulation.failure();
  return simulation.bodies().nodes.position;
}

TEST(Company, ABlockKilometresAwayFromTheGroundBuildsNothingOfContact) {
  const Project project = test::rock_project(30, {stage_of(100)});
  const BlockSystem system = test::block_system({slab(), rigid_cube("B", Vec3(0, 0, far_away))});
  Simulation simulation(project, system);
  while (!simulation.finished()) simulation.step();
  for (const char* name : {"normal contact", "shear contact", "rebound", "missed contacts", "updated normals",
                           "penalty scaling", "followed springs", "nonlinear elimination"}) {
    const auto effects = simulation.effects();
    const EffectOutcome& effect = effect_called(effects, name);
    EXPECT_FALSE(effect.active) << name;
    EXPECT_EQ(effect.reason, "no block can reach another within the run") << name;
    EXPECT_EQ(effect.built + effect.evaluations, 0) << name;
  }
  const RunWork work = simulation.work();
  EXPECT_EQ(work.body_pairs + work.facet_searches + work.facet_pairs + work.contact_points, 0);
  EXPECT_NEAR(simulation.bodies().nodes.position[8].z(), far_away - 0.5 * 9.81, 1e-6);
}

TEST(Company, ABlockThatIsAloneFallsAsWithContactOnBitForBit) {
  Project project = test::rock_project(30, {stage_of(100)});
  const BlockSystem system = test::block_system({slab(), rigid_cube("B", Vec3(0, 0, far_away))});
  const auto alone = positions_after(project, system);
  project.solver.effects.contact = Switch::on;
  EXPECT_EQ(alone, positions_after(project, system));
}

TEST(Company, ABlockFarAwayThatFliesFastAddsNothingToTheContactWorkOfTheOthers) {
  const auto contact_work = [](bool with_far, Switch contact) {
    Project project = test::rock_project(30, {stage_of(100)});
    project.gravity = test::tilted_gravity(40);
    project.solver.effects.contact = contact;
    BlockSystem system = test::block_system({slab(), rigid_cube("A", Vec3(0, 0, 0)), rigid_cube("B", Vec3(1.3, 0, 0))});
    if (with_far) {
      system.blocks.push_back(rigid_cube("far", Vec3(0, 0, far_away)));
      project.velocities = {{"far", Vec3(0, 0, 100), Vec3::Zero()}};
    }
    Simulation simulation(project, system);
    while (!simulation.finished()) simulation.step();
    EXPECT_TRUE(simulation.converged()) << simulation.failure();
    const RunWork work = simulation.work();
    return std::array{work.contact_points, work.facet_pairs, work.facet_searches, work.body_pairs};
  };
  const auto without = contact_work(false, Switch::called_for);
  EXPECT_GT(without[0], 0);
  EXPECT_EQ(contact_work(true, Switch::called_for), without);
  EXPECT_EQ(contact_work(true, Switch::on)[0], without[0]) << "its speed says nothing of how far others look";
}

TEST(Company, ABlockThrownFromFarAwayArrivesAndTouchesAsIfContactHadAlwaysBeenOn) {
  Project project = test::rock_project(0, {stage_of(2200, 1e-3)});
  project.gravity.setZero();
  project.velocities = {{"thrown", Vec3(50, 0, 0), Vec3::Zero()}};
  project.joints[0].restitution = 0;
  const BlockSystem system =
      test::block_system({rigid_cube("thrown", Vec3(-101, 0, 0)), rigid_cube("waits", Vec3(0, 0, 0))});
  Simulation simulation(project, system);
  simulation.step();
  EXPECT_FALSE(effect_called(simulation.effects(), "normal contact").active) << "it will take 2 s";
  while (!simulation.finished()) simulation.step();
  ASSERT_TRUE(simulation.converged()) << simulation.failure();
  EXPECT_TRUE(effect_called(simulation.effects(), "normal contact").active);
  EXPECT_EQ(effect_called(simulation.effects(), "normal contact").built, 1);
  EXPECT_GT(effect_called(simulation.effects(), "rebound").evaluations, 0);
  const auto& now = simulation.bodies().nodes;
  EXPECT_NEAR(now.velocity[8].x(), 25, 0.1) << "both go on together";
  EXPECT_NEAR(now.velocity[0].x(), 25, 0.1);
  const std::vector<Vec3> found = now.position;
  project.solver.effects.contact = Switch::on;
  EXPECT_EQ(found, positions_after(project, system));
}

TEST(Company, ABaseThatIsDrivenMeetsWhomItCanReach) {
  Project project = test::rock_project(0, {stage_of(300)});
  project.gravity.setZero();
  const BlockSystem system = test::block_system({slab(), rigid_cube("B", Vec3(0, 0, 30))});
  EXPECT_EQ(blocks_alone_in_run(project, system, {}), 1u);
  project.constraints = {{"ground", {}, {0, 0, 0}, {{0, Vec3::Zero()}, {3, Vec3(0, 0, 31)}}}};
  EXPECT_EQ(blocks_alone_in_run(project, system, {}), 0u);
  EXPECT_GT(positions_after(project, system)[8].z(), 30.5) << "it was pushed up";
}

TEST(Company, ALoadThatCanBringABlockToAnotherOneIsReckonedWith) {
  Project project = test::rock_project(0, {stage_of(100)});
  project.gravity.setZero();
  const BlockSystem system = test::block_system({rigid_cube("A", Vec3(0, 0, 0)), rigid_cube("B", Vec3(40, 0, 0))});
  EXPECT_EQ(blocks_alone_in_run(project, system, {}), 2u);
  project.loads = {{"A", Vec3(0.5, 0.5, 0.5), Vec3(2600 * 80, 0, 0)}};  // 80 m/s²
  EXPECT_EQ(blocks_alone_in_run(project, system, {}), 0u);
  EXPECT_GT(positions_after(project, system)[8].x(), 40) << "it was struck";
}

class CompanyOfTwo : public testing::Test {
 protected:
  Project project = test::rock_project(0, {stage_of(100)});
  BlockSystem system = test::block_system({rigid_cube("A", Vec3(0, 0, 0)), rigid_cube("B", Vec3(40, 0, 0))});
  BodySet bodies{project, system};
  Company company{2, StepTolerances{}, Company::Choice::by_reach};

  void begin() { company.begin_stage({Pull{}, Pull{}}, {false, false}); }
};

TEST_F(CompanyOfTwo, WhoHasGoneFartherThanForeseenIsAskedAnew) {
  begin();
  EXPECT_TRUE(company.is_due(0));
  company.look(bodies, 1, 0.01);
  EXPECT_TRUE(company.is_alone(0));
  EXPECT_FALSE(company.any());
  EXPECT_FALSE(company.is_due(0.01));
  company.moved(0, 1);
  EXPECT_FALSE(company.is_due(0.01)) << "it may turn";
  company.moved(0, 1);
  EXPECT_TRUE(company.is_due(0.01));
  for (Vec3& x : std::span(bodies.nodes.position).first(8)) x.x() += 38;
  company.look(bodies, 1, 0.01);
  EXPECT_TRUE(company.any()) << "it lies a metre before the other now";
  EXPECT_EQ(company.never_met(bodies), 0u);
}

TEST_F(CompanyOfTwo, AStepThatLeadsFartherThanForeseenIsTriedAgainWithMoreRoom) {
  begin();
  company.look(bodies, 1, 0.01);
  Increment d = Increment::Zero(bodies.unknowns());
  d[0] = 0.5;
  EXPECT_FALSE(company.goes_too_far(bodies, d));
  d[0] = 39;
  EXPECT_TRUE(company.goes_too_far(bodies, d));
  EXPECT_TRUE(company.is_due(0));
  company.look(bodies, 1, 0.01);
  EXPECT_TRUE(company.any()) << "it would have passed through the other";
  EXPECT_FALSE(company.goes_too_far(bodies, d));
}

TEST_F(CompanyOfTwo, SpeedBringsThemTogether) {
  project.velocities = {{"A", Vec3(50, 0, 0), Vec3::Zero()}};
  EXPECT_EQ(blocks_alone_in_run(project, system, {}), 0u) << "50 m in a second";
  bodies.nodes.velocity[bodies.nodes.free[0]] = Vec3(50, 0, 0);
  begin();
  company.look(bodies, 1, 0.01);
  EXPECT_TRUE(company.any());
}

TEST(Company, WhatSlidesAndCollidesDoesSoWhateverLandsFarAway) {
  const auto positions = [](double edge_far_away, double above) {
    Project project = test::rock_project(30, {stage_of(60)});
    project.gravity = test::tilted_gravity(40);
    BlockSystem system =
        test::block_system({slab(), rigid_cube("A", Vec3(0, 0, 0)), rigid_cube("B", Vec3(1.01, 0, 0))});
    project.velocities = {{"A", Vec3(0.5, 0, 0), Vec3::Zero()}};
    project.solver.tolerance = 1e-12;             // what steps leave out of balance must not differ
    project.solver.penetration_tolerance = 5e-4;  // stiffer contacts make more of the last place
    if (edge_far_away > 0) {
      const Vec3 corner(0, far_away, 0), edge = Vec3::Constant(edge_far_away);
      system.blocks.push_back(
          test::box_block("far slab", corner - edge, corner + Vec3(2, 1, 0).cwiseProduct(edge), BodyKind::fixed));
      system.blocks.push_back(
          test::box_block("far", corner + Vec3(0, 0, above), corner + Vec3(0, 0, above) + edge, BodyKind::rigid));
    }
    std::vector<Vec3> all = positions_after(project, system);
    all.resize(24);  // of the slab, A and B
    return all;
  };
  const auto without = positions(0, 0);
  EXPECT_GT((without[16] - Vec3(1.01, 0, 0)).norm(), 0.1) << "B was hit";
  for (const double edge : {0.01, 1.0, 100.0})
    for (const double above : {0.0, 0.01}) {
      const std::vector<Vec3> with = positions(edge, above);
      // How far contacts are looked for follows the fastest and the smallest block, and turns bits in the last place.
      for (std::size_t n = 0; n < with.size(); ++n)
        EXPECT_LT((with[n] - without[n]).norm(), 1e-12) << edge << " m, " << above << ", node " << n;
    }
}

}  // namespace
}  // namespace talus
