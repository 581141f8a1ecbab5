#include "run/effect_costs.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "base/error.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

using testing::HasSubstr;

Project short_project(double friction_angle = 30) {
  Project project = test::rock_project(friction_angle, {{"slide", StageKind::dynamic, 0.01, 3, {}}});
  project.gravity = test::tilted_gravity(10);
  return project;
}

BlockSystem one_of_each_body() {
  BlockSystem system = test::cube_on_slab();
  system.blocks.push_back(test::box_block("A", Vec3(3, 0, 0), Vec3(4, 1, 1), BodyKind::affine));
  system.blocks.push_back(test::box_block("R", Vec3(6, 0, 0), Vec3(7, 1, 1), BodyKind::rigid));
  return system;
}

std::vector<EffectCost> costs_of(const Project& project, const BlockSystem& system) {
  return effect_costs(project, system, scene_size(project, system));
}

EffectCost cost_of(EffectKind kind, const Project& project, const BlockSystem& system) {
  const auto costs = costs_of(project, system);
  const auto found = std::find_if(costs.begin(), costs.end(), [&](const EffectCost& c) { return c.kind == kind; });
  return found == costs.end() ? EffectCost{} : *found;
}

TEST(EffectCosts, CountsWhatMovesAndWhatTheFirstStepWouldFindInContact) {
  const Project project = short_project();
  const BlockSystem system = one_of_each_body();
  const SceneSize size = scene_size(project, system);
  EXPECT_EQ(size.tetrahedra, static_cast<long>(system.blocks[1].mesh.tetrahedra.size()));
  EXPECT_EQ(size.affine_blocks, 1);
  EXPECT_EQ(size.rigid_blocks, 1);
  EXPECT_EQ(size.bonded_points, 0);
  EXPECT_EQ(size.sheared_points, size.loose_points);
  Simulation simulation(project, system);
  EXPECT_EQ(size.loose_points, simulation.step().contacts);
  EXPECT_GE(size.loose_points, 12) << "three faces of four corners at least";
}

TEST(EffectCosts, LookingForContactsChangesNothing) {
  const Project project = short_project();
  const BlockSystem system = one_of_each_body();
  Simulation looked(project, system), not_looked(project, system);
  looked.look_for_contacts();
  for (int i = 0; i < 3; ++i) {
    looked.look_for_contacts();
    looked.step();
    not_looked.step();
  }
  const auto &a = looked.bodies().nodes.position, &b = not_looked.bodies().nodes.position;
  EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
}

TEST(EffectCosts, PointsOfAJointWithCohesionAreBonded) {
  Project project = short_project();
  project.joints[0].cohesion = 1e5;
  const SceneSize size = scene_size(project, test::cube_on_slab());
  EXPECT_EQ(size.loose_points, 0);
  EXPECT_GE(size.bonded_points, 4);
  EXPECT_EQ(size.sheared_points, size.bonded_points);
  EXPECT_THAT(cost_of(EffectKind::cohesion_and_tension, project, test::cube_on_slab()).items,
              testing::EndsWith(" bonded points at the start"));
}

TEST(EffectCosts, WhatIsOffCostsNothingAndPaysForNothing) {
  const auto costs = costs_of(short_project(0), test::cube_on_slab());
  int off = 0;
  for (const EffectCost& cost : costs) {
    EXPECT_FALSE(cost.reason.empty()) << to_string(cost.kind);
    EXPECT_EQ(cost.active, cost.seconds > 0) << to_string(cost.kind);
    EXPECT_EQ(cost.active, !cost.items.empty()) << to_string(cost.kind);
    off += cost.active ? 0 : 1;
  }
  EXPECT_EQ(off, 9)
      << "neo-Hookean elasticity, initial stress, constraint, load, shear, cohesion, damping, restitution, "
         "elimination";
}

TEST(EffectCosts, SaysInWordsWhatIsPaidFor) {
  Project project = short_project();
  project.loads = {{"B", Vec3(0.5, 0.5, 0.5), Vec3(1, 0, 0)}};
  const BlockSystem system = one_of_each_body();
  EXPECT_EQ(cost_of(EffectKind::point_load, project, system).items, "1 load");
  const std::string tetrahedra = std::to_string(system.blocks[1].mesh.tetrahedra.size()) + " tetrahedra";
  EXPECT_EQ(cost_of(EffectKind::elasticity, project, system).items, tetrahedra + ", 1 affine block");
  EXPECT_EQ(cost_of(EffectKind::inertia, project, system).items, tetrahedra + ", 1 affine block, 1 rigid block");
  EXPECT_THAT(cost_of(EffectKind::normal_contact, project, system).items, HasSubstr(" contact points at the start"));
}

TEST(EffectCosts, ElementsArePaidForByTheLawOfTheirRock) {
  Project project = short_project();
  const BlockSystem system = one_of_each_body();
  project.materials[0].law = MaterialLaw::neo_hookean;
  EXPECT_FALSE(cost_of(EffectKind::elasticity, project, system).active);
  const std::string tetrahedra = std::to_string(system.blocks[1].mesh.tetrahedra.size()) + " tetrahedra";
  EXPECT_EQ(cost_of(EffectKind::neo_hookean_elasticity, project, system).items, tetrahedra + ", 1 affine block");
  EXPECT_EQ(cost_of(EffectKind::inertia, project, system).items, tetrahedra + ", 1 affine block, 1 rigid block");
}

TEST(EffectCosts, GrowWithTheNumberOfWhatIsPaidFor) {
  const Project project = short_project();
  const BlockSystem system = test::cube_on_slab();
  const auto elasticity = [&](long tetrahedra) {
    return effect_costs(project, system, {.tetrahedra = tetrahedra, .loose_points = 0})[0];
  };
  ASSERT_EQ(elasticity(1).kind, EffectKind::elasticity);
  EXPECT_DOUBLE_EQ(elasticity(12400).seconds, 12400 * elasticity(1).seconds);
  EXPECT_EQ(elasticity(12400).items, "12 400 tetrahedra");
  EXPECT_EQ(elasticity(1).items, "1 tetrahedron");
}

TEST(EffectCosts, ASceneInWhichNothingMovesHasNone) {
  BlockSystem system = test::cube_on_slab();
  system.blocks[1].body = BodyKind::fixed;
  const SceneSize size = scene_size(short_project(), system);
  EXPECT_EQ(size.tetrahedra + size.affine_blocks + size.rigid_blocks + size.loose_points, 0);
  for (const EffectCost& cost : effect_costs(short_project(), system, size))
    EXPECT_EQ(cost.seconds, 0) << to_string(cost.kind);
}

TEST(EffectCosts, AProjectThatHasNoStageYetHasItsBodiesAndNoContacts) {
  Project project = short_project();
  project.stages.clear();
  const SceneSize size = scene_size(project, test::cube_on_slab());
  EXPECT_GT(size.tetrahedra, 0);
  EXPECT_EQ(size.loose_points, 0);
  EXPECT_GT(cost_of(EffectKind::elasticity, project, test::cube_on_slab()).seconds, 0);
}

TEST(EffectCosts, AMonitorOutsideItsBlockIsRefusedAsTheRunRefusesIt) {
  Project project = short_project();
  project.monitors = {{"P1", "B", Vec3(50, 50, 50)}};
  EXPECT_THROW(scene_size(project, test::cube_on_slab()), InputError);
}

}  // namespace
}  // namespace talus
