// Rigid, affine and meshed blocks in one scene, in contact with each other.
#include <gmock/gmock.h>

#include <algorithm>

#include "solve/simulation.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

using test::box_block;
constexpr double weight = 2600 * 9.81;  ///< N, of a unit cube

/// Cubes of these kinds on a slab, from the bottom up.
BlockSystem stack(const std::vector<BodyKind>& kinds) {
  std::vector<Block> blocks{box_block("ground", Vec3(-2, -2, -1), Vec3(3, 3, 0), BodyKind::fixed)};
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const double z = static_cast<double>(i);
    blocks.push_back(box_block("B" + std::to_string(i + 1), Vec3(0, 0, z), Vec3(1, 1, z + 1), kinds[i]));
  }
  return test::block_system(std::move(blocks));
}

/// Normal force between a block and the next one above [N].
double force_on_top_of(const Simulation& simulation, int block) {
  double sum = 0;
  for (const ContactSample& contact : simulation.contacts())
    if (std::minmax(contact.blocks[0], contact.blocks[1]) == std::minmax(block, block + 1)) sum += contact.normal_force;
  return sum;
}

TEST(MixedBodies, StackOfAllKindsCarriesItsWeightInAnyOrder) {
  std::vector<BodyKind> kinds{BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra};
  do {
    const Project project = test::rock_project(30, {{"stand", StageKind::static_, 0.1, 60, {}}});
    const BlockSystem system = stack(kinds);
    Simulation simulation(project, system);
    while (!simulation.finished()) simulation.step();
    ASSERT_TRUE(simulation.converged()) << simulation.failure();
    for (int below = 0; below < 3; ++below)
      EXPECT_NEAR(force_on_top_of(simulation, below), (3 - below) * weight, 1e-6 * weight)
          << to_string(kinds[0]) << ", " << to_string(kinds[1]) << ", " << to_string(kinds[2]) << " above " << below;
  } while (std::next_permutation(kinds.begin(), kinds.end()));
}

TEST(MixedBodies, WhatStressesAnAffineBlockIsTheWeightAboveItsMiddle) {
  const Project project = test::rock_project(30, {{"stand", StageKind::static_, 0.01, 60, {}}});
  const BlockSystem system = stack({BodyKind::affine, BodyKind::rigid});
  Simulation simulation(project, system);
  while (!simulation.finished()) simulation.step();
  const Frame frame = simulation.frame(0);
  const int first = simulation.bodies().bodies[1].first_tetrahedron;
  for (int t = first; t < first + 6; ++t) EXPECT_NEAR(frame.stress[t][2], -1.5 * weight, 2e-3 * weight);
  for (int t = first + 6; t < first + 12; ++t) EXPECT_EQ(frame.stress[t].norm(), 0) << "a rigid block has no stress";
}

/// A cube that flies at one of another kind, without gravity or friction: what they have together of momentum stays.
TEST(MixedBodies, CollisionKeepsMomentumAndAngularMomentum) {
  for (const BodyKind other : {BodyKind::affine, BodyKind::tetrahedra, BodyKind::rigid}) {
    Project project = test::rock_project(0, {{"fly", StageKind::dynamic, 1e-3, 300, {}}});
    project.gravity.setZero();
    project.solver.integrator = Integrator::generalized_alpha;
    InitialVelocity start;
    start.block = "flies";
    start.linear = Vec3(2, 0, 0);
    project.velocities = {start};
    const BlockSystem system = test::block_system({box_block("stands", Vec3(1.1, 0.3, 0.2), Vec3(2.1, 1.3, 1.2), other),
                                                   box_block("flies", Vec3(0, 0, 0), Vec3(1, 1, 1), BodyKind::rigid)});
    Simulation simulation(project, system);
    bool touched = false;
    while (!simulation.finished()) {
      simulation.step();
      for (const ContactSample& contact : simulation.contacts()) touched = touched || contact.normal_force > 0;
    }
    ASSERT_TRUE(simulation.converged()) << simulation.failure();
    EXPECT_TRUE(touched);
    const Vec3 sum = block_motion(simulation.bodies(), 0).velocity + block_motion(simulation.bodies(), 1).velocity;
    EXPECT_LT((sum - Vec3(2, 0, 0)).norm(), 1e-8) << to_string(other);
    EXPECT_GT(block_motion(simulation.bodies(), 0).velocity.x(), 0.5) << to_string(other);
    EXPECT_GT(block_motion(simulation.bodies(), 1).rotation, 0.01) << "it was hit out of its middle";
  }
}

TEST(MixedBodies, SingleBodiesAreHeldByAStageAndReleased) {
  for (const BodyKind kind : {BodyKind::rigid, BodyKind::affine}) {
    Project project = test::rock_project(
        30, {{"hold", StageKind::dynamic, 0.01, 20, {}}, {"fall", StageKind::dynamic, 0.01, 20, {}}});
    project.stages[0].blocks = {{"B", BodyKind::fixed}};
    project.stages[1].blocks = {{"B", kind}};
    const BlockSystem system = test::block_system({box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1), kind)});
    Simulation simulation(project, system);
    for (int i = 0; i < 20; ++i) simulation.step();
    EXPECT_EQ(block_motion(simulation.bodies(), 0).displacement.norm(), 0);
    while (!simulation.finished()) simulation.step();
    EXPECT_NEAR(block_motion(simulation.bodies(), 0).displacement.z(), -0.5 * 9.81 * 0.04, 1e-12) << to_string(kind);
  }
}

TEST(MixedBodies, HeldPointAndALoadActOnARigidBlock) {
  Project project = test::rock_project(30, {{"hang", StageKind::static_, 0.01, 5, {}}});
  project.constraints = {{"B", Vec3(0.5, 0.5, 0.9), {{0.0, 0.0, 0.0}}}};
  project.loads = {{"B", Vec3(0.5, 0.5, 0.1), Vec3(0, 0, -1e4)}};
  const BlockSystem system = test::block_system({box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1), BodyKind::rigid)});
  Simulation simulation(project, system);
  while (!simulation.finished()) simulation.step();
  ASSERT_TRUE(simulation.converged()) << simulation.failure();
  const double stiffness = 100 * 5e9;  // N/m, E h
  EXPECT_NEAR(block_motion(simulation.bodies(), 0).displacement.z(), -(weight + 1e4) / stiffness,
              1e-6 * (weight + 1e4) / stiffness);
}

}  // namespace
}  // namespace talus
