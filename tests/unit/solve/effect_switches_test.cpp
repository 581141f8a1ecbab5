// What a project switches on or off is on or off; what was idle leaves the same bits.
#include <gmock/gmock.h>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

using Member = Switch EffectSwitches::*;

struct Ran {
  std::vector<Vec3> positions;
  std::vector<EffectOutcome> effects;
  long block_steps_asleep = 0;
  double depth = 0;

  const EffectOutcome& effect(const std::string& name) const {
    return *std::find_if(effects.begin(), effects.end(), [&](const auto& e) { return e.name == name; });
  }
};

Ran ran(const Project& project, const BlockSystem& system) {
  Simulation simulation(project, system);
  double depth = 0;
  while (!simulation.finished()) depth = std::max(depth, simulation.step().max_relative_penetration);
  EXPECT_TRUE(simulation.converged()) << simulation.failure();
  return {simulation.bodies().nodes.position, simulation.effects(), simulation.work().block_steps_asleep, depth};
}

Project falling(int steps = 100) { return test::rock_project(30, {{"fall", StageKind::dynamic, 0.005, steps, {}}}); }

BlockSystem block_above_slab(double height) {
  return test::block_system({test::box_block("ground", Vec3(-5, -5, -1), Vec3(20, 5, 0), BodyKind::fixed),
                             test::box_block("B", Vec3(0, 0, height), Vec3(1, 1, 1 + height), BodyKind::rigid)});
}

struct Named {
  const char* name;
  Member member;
};

constexpr Named switches[] = {{"normal contact", &EffectSwitches::contact},
                              {"rebound", &EffectSwitches::rebound},
                              {"restitution", &EffectSwitches::restitution},
                              {"missed contacts", &EffectSwitches::missed_contacts},
                              {"updated normals", &EffectSwitches::updated_normals},
                              {"penalty scaling", &EffectSwitches::penalty_scaling},
                              {"followed springs", &EffectSwitches::followed_springs},
                              {"acceleration reset", &EffectSwitches::acceleration_reset},
                              {"sleep", &EffectSwitches::sleep},
                              {"nonlinear elimination", &EffectSwitches::elimination}};

TEST(EffectSwitches, EachIsObeyedAndSaysSo) {
  Project project = falling(200);
  project.joints[0].restitution = 0.3;
  BlockSystem system = block_above_slab(0.2);
  system.blocks.push_back(system.blocks.back());  // one block alone could not be balanced apart from others
  system.blocks.back().name = "second";
  for (Vec3& node : system.blocks.back().mesh.nodes) node.x() += 3;
  for (const auto& [name, member] : switches) {
    EXPECT_TRUE(ran(project, system).effect(name).active) << name << " is called for";
    Project without = project, with = project;
    without.solver.effects.*member = Switch::off;
    const Ran off = ran(without, system);
    EXPECT_FALSE(off.effect(name).active) << name;
    EXPECT_THAT(off.effect(name).reason, testing::StartsWith("the project switches ")) << name;
    EXPECT_EQ(off.effect(name).built + off.effect(name).evaluations, 0) << name;
    with.solver.extras = Extras::none;
    if (std::string(name) == "restitution") with.solver.effects.rebound = Switch::on;
    with.solver.effects.*member = Switch::on;
    const Ran on = ran(with, system);
    EXPECT_TRUE(on.effect(name).active) << name << ": " << on.effect(name).reason;
  }
}

TEST(EffectSwitches, WhatIsIdleLeavesTheSameBitsOnOrOff) {
  const Project project = falling();
  const BlockSystem system = block_above_slab(2);  // it falls 1.2 m
  const std::vector<Vec3> as_called = ran(project, system).positions;
  EXPECT_NEAR(as_called[8].z(), 2 - 0.5 * 9.81 * 0.25, 1e-2);
  for (const auto& [name, member] : switches)
    for (const Switch choice : {Switch::on, Switch::off}) {
      Project other = project;
      other.solver.effects.*member = choice;
      if (std::string(name) == "acceleration reset") continue;  // it acts on who begins to fall, too
      EXPECT_EQ(ran(other, system).positions, as_called) << name << ' ' << to_string(choice);
    }
}

TEST(EffectSwitches, WithContactOffABlockFallsThroughTheGround) {
  Project project = falling();
  project.solver.effects.contact = Switch::off;
  EXPECT_LT(ran(project, block_above_slab(0)).positions[8].z(), -1.1);
  project.solver.effects.contact = Switch::on;
  EXPECT_NEAR(ran(project, block_above_slab(0)).positions[8].z(), 0, 1e-3);
}

TEST(EffectSwitches, WithSleepOffNobodySleeps) {
  Project project = falling(200);
  EXPECT_GT(ran(project, block_above_slab(0)).block_steps_asleep, 0);
  project.solver.effects.sleep = Switch::off;
  EXPECT_EQ(ran(project, block_above_slab(0)).block_steps_asleep, 0);
}

TEST(EffectSwitches, WithoutRestitutionABlockThatHadOneStays) {
  Project project = falling(90);
  project.joints[0].restitution = 0.9;
  const auto height = [&] { return ran(project, block_above_slab(0.2)).positions[8].z(); };
  EXPECT_GT(height(), 0.05) << "it has bounced";
  project.solver.effects.restitution = Switch::off;
  EXPECT_LT(height(), 1e-3);
}

TEST(EffectSwitches, WithoutPenaltyScalingAPenetrationIsNotHeld) {
  Project project = falling(90);
  project.solver.contact_stiffness = 1e-4;
  EXPECT_LT(ran(project, block_above_slab(0)).depth, 2e-3);
  project.solver.effects.penalty_scaling = Switch::off;
  EXPECT_GT(ran(project, block_above_slab(0)).depth, 4e-3);
}

}  // namespace
}  // namespace talus
