#include <gtest/gtest.h>

#include "bodies/block_motion.hpp"
#include "support/solver_scenes.hpp"

/// Blocks that are moved, and what stands on them.
namespace talus {
namespace {

/// A base that starts at 0.25 m/s goes 1.25 mm in the first step. What the accelerations at its start made of that, by
/// friction between faces that were said to be so deep in each other, threw the cube aside.
TEST(PrescribedMotion, ABaseThatStartsThrowsNothingOff) {
  for (const BodyKind kind : {BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra}) {
    const Vec3 velocity(0.15, 0, 0.2);
    Project project = test::rock_project(35, {{"shake", StageKind::dynamic, 0.005, 20, {}}});
    Constraint base;
    base.block = "ground";
    base.table = {{0, Vec3::Zero()}, {1, velocity}};
    project.constraints.push_back(base);
    BlockSystem system = test::cube_on_slab();
    system.blocks[1].body = kind;
    Simulation simulation(project, system);
    double fastest = 0;
    while (!simulation.finished()) {
      simulation.step();
      fastest = std::max(fastest, block_motion(simulation.bodies(), 1).velocity.norm());
    }
    ASSERT_TRUE(simulation.converged()) << to_string(kind) << simulation.failure();
    EXPECT_GT(fastest, 0.5 * velocity.norm()) << to_string(kind);
    EXPECT_LT(fastest, 2 * velocity.norm()) << to_string(kind) << ": no faster than a blow that takes nothing throws";
  }
}

}  // namespace
}  // namespace talus
