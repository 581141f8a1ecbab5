// Blocks of neo-Hookean rock in motion and at rest, strained by more than linear rock bears.
#include <gmock/gmock.h>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

Project soft_project(std::vector<Stage> stages) {
  Project project = test::rock_project(0, std::move(stages));
  project.materials = {{"soft", 1000, 1e5, 0, 0, MaterialLaw::neo_hookean}};
  return project;
}

/// What is left of the volume of the tetrahedron that is squeezed most.
double least_volume(const Simulation& simulation) {
  const NodeSet& nodes = simulation.bodies().nodes;
  double least = 1;
  for (const Element& element : simulation.bodies().elements) {
    Corners now, before;
    for (int i = 0; i < 4; ++i) {
      now[i] = nodes.position[element.nodes[i]];
      before[i] = nodes.reference[element.nodes[i]];
    }
    least = std::min(least, element_shape(now).volume / element_shape(before).volume);
  }
  return least;
}

/// With ν = 0 a frictionless block neither spreads nor needs to: σ = μ(a² − 1)/a across its base, the load over 1 m².
TEST(SoftRock, AffineBlockIsSqueezedAsTheFormulaSays) {
  Project project = soft_project({{"press", StageKind::static_, 1, 40, {}}});
  project.gravity.setZero();
  project.joints[0].normal_stiffness = 1e12;
  const double load = 3e5;  // three times the modulus: linear rock would be inside out
  project.loads = {{"B", Vec3(0.5, 0.5, 1), Vec3(0, 0, -load)}};
  BlockSystem system = test::cube_on_slab();
  system.blocks[1].body = BodyKind::affine;
  Simulation simulation(project, system);
  long cuts = 0;
  while (!simulation.finished()) cuts += simulation.step().cuts;
  ASSERT_TRUE(simulation.converged()) << simulation.failure();
  EXPECT_EQ(cuts, 0);
  const double mu = 5e4, half = load / (2 * mu), height = std::sqrt(half * half + 1) - half;
  EXPECT_NEAR(least_volume(simulation), height, 1e-6);
}

TEST(SoftRock, BlockThatIsThrownDownHardKeepsItsShapeAndGainsNoEnergy) {
  Project project = soft_project({{"fall", StageKind::dynamic, 2e-3, 300, {}}});
  project.velocities = {{.block = "B", .linear = {0, 0, -10}}};  // as fast as its waves
  Simulation simulation(project, test::cube_on_slab());
  double lost = 0, moved = 0, squeezed = 1;
  while (!simulation.finished()) {
    const EnergyLedger energy = simulation.step().energy;
    const double now = energy.friction_dissipated + energy.damping_dissipated + energy.integration_loss;
    moved = std::max({moved, energy.kinetic, energy.elastic});
    EXPECT_GE(now, lost - 1e-9 * moved) << simulation.time();
    EXPECT_LT(std::abs(energy.remainder), 1e-8 * moved) << simulation.time();
    lost = now;
    squeezed = std::min(squeezed, least_volume(simulation));
  }
  EXPECT_TRUE(simulation.converged()) << simulation.failure();
  EXPECT_LT(squeezed, 0.6) << "it is not squeezed hard";
  EXPECT_GT(squeezed, 0.1);
}

}  // namespace
}  // namespace talus
