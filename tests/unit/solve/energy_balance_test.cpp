// The ledger of whole runs: what time integration eats is known in closed form for the simplest of them.
#include <gmock/gmock.h>

#include <numbers>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

double moved(const EnergyLedger& e) {
  return std::max({std::abs(e.kinetic), std::abs(e.elastic), std::abs(e.potential), std::abs(e.contact),
                   std::abs(e.friction_dissipated), std::abs(e.constraint_work)});
}

TEST(EnergyBalance, ClosesInARunWithImpactFrictionAndDamping) {
  Project project = test::rock_project(
      25, {{"settle", StageKind::static_, 0.01, 10, {}}, {"slide", StageKind::dynamic, 0.01, 100, {}}});
  project.gravity = test::tilted_gravity(30);
  project.materials[0].damping = 0.1;
  BlockSystem system = test::cube_on_slab();
  system.blocks.push_back(test::box_block("falling", Vec3(3, 0, 0.5), Vec3(4, 1, 1.5)));
  Simulation simulation(project, system);
  double most = 0;
  EnergyLedger ledger;
  while (!simulation.finished()) {
    ledger = simulation.step().energy;
    most = std::max(most, moved(ledger));
  }
  ASSERT_TRUE(simulation.converged());
  EXPECT_LT(std::abs(ledger.remainder), 1e-8 * most);
  EXPECT_GT(ledger.friction_dissipated, 0.01 * most);
  EXPECT_GT(ledger.damping_dissipated, 1e-3 * most);
}

/// A cube stretched along x by 1e-4 and let go, without gravity: it rings.
EnergyLedger after_ringing(Integrator integrator, double spectral_radius, Strain strain, double* start) {
  Project project = test::rock_project(0, {{"ring", StageKind::dynamic, 5e-5, 200, {}}});
  project.gravity = Vec3::Zero();
  project.solver.integrator = integrator;
  project.solver.spectral_radius = spectral_radius;
  project.solver.strain = strain;
  project.in_situ.emplace_back();
  project.in_situ[0].stress << 5e5, 0, 0, 0, 0, 0;
  const BlockSystem system = test::block_system({test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1))});
  Simulation simulation(project, system);
  EnergyLedger ledger;
  double most = 0;
  while (!simulation.finished()) {
    ledger = simulation.step().energy;
    most = std::max(most, ledger.kinetic);
  }
  *start = most;
  EXPECT_LT(std::abs(ledger.remainder), 1e-8 * most);
  return ledger;
}

/// Mechanical energy goes up and down by what Newmark's method holds; both together only go down (Krenk 2006).
TEST(EnergyBalance, NewmarkGivesBackNoMoreThanItHolds) {
  for (const BodyKind body : {BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra}) {
    Project project = test::rock_project(35, {{"shake", StageKind::dynamic, 0.005, 120, {}}});
    Constraint base;
    base.block = "ground";
    for (int i = 0; i <= 120; ++i)
      base.table.push_back({0.005 * i, {0.004 * std::sin(2 * std::numbers::pi * 3 * 0.005 * i), 0, 0}});
    project.constraints.push_back(base);
    BlockSystem system = test::cube_on_slab();
    system.blocks[1].body = body;
    Simulation simulation(project, system);
    double least = 0, moved_at_most = 0, swing = 0, loss_before = 0;
    while (!simulation.finished()) {
      const EnergyLedger& ledger = simulation.step().energy;
      const double gone =
          ledger.friction_dissipated + ledger.damping_dissipated + ledger.integration_loss - ledger.integration_reserve;
      moved_at_most = std::max(moved_at_most, moved(ledger));
      EXPECT_GE(gone, least - 1e-7 * moved_at_most) << static_cast<int>(body) << " at " << simulation.time();
      least = std::max(least, gone);
      swing = std::max(swing, loss_before - ledger.integration_loss);
      loss_before = ledger.integration_loss;
    }
    ASSERT_TRUE(simulation.converged());
    if (body != BodyKind::rigid) {
      EXPECT_GT(swing, 1e-6 * moved_at_most) << "without the reserve it would grow";
    }
  }
}

TEST(EnergyBalance, GeneralizedAlphaWithSpectralRadiusOneConservesWhatIsLinear) {
  double most = 0;
  const EnergyLedger ledger = after_ringing(Integrator::generalized_alpha, 1, Strain::incremental, &most);
  EXPECT_GT(most, 1);
  // The incremental form re-measures shapes every step: linear but for the strain, 1e-4.
  EXPECT_LT(std::abs(ledger.integration_loss), 1e-3 * most);
  double corotated = 0;
  const EnergyLedger turned = after_ringing(Integrator::generalized_alpha, 1, Strain::corotational, &corotated);
  EXPECT_LT(std::abs(turned.integration_loss), 1e-4 * corotated);
}

TEST(EnergyBalance, ThePapersIntegratorAndNewmarkDampOscillations) {
  double most = 0;
  EXPECT_GT(after_ringing(Integrator::constant_acceleration, 1, Strain::corotational, &most).integration_loss,
            0.5 * most);
  EXPECT_GT(after_ringing(Integrator::newmark, 1, Strain::corotational, &most).integration_loss, 0.5 * most);
  EXPECT_GT(after_ringing(Integrator::generalized_alpha, 0.5, Strain::corotational, &most).integration_loss,
            0.01 * most);
}

TEST(EnergyBalance, AForceThatDecreasesReturnsNoEnergy) {
  // Newmark's method takes Δ²/32 m a² when a push sets in, and would give a quarter back when it halves (Krenk 2006).
  Project project = test::rock_project(0, {{"pushed", StageKind::dynamic, 0.01, 4, {}}});
  project.gravity = Vec3::Zero();
  project.solver.integrator = Integrator::newmark;
  project.solver.strain = Strain::incremental;
  project.loads = {{"B",
                    Vec3(0.5, 0.5, 0.5),
                    Vec3::Zero(),
                    {{0, Vec3(1e4, 0, 0)}, {0.0201, Vec3(1e4, 0, 0)}, {0.0202, Vec3(5e3, 0, 0)}}}};
  const BlockSystem system = test::block_system({test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1), BodyKind::rigid)});
  Simulation simulation(project, system);
  while (!simulation.finished()) {
    const EnergyLedger ledger = simulation.step().energy;
    EXPECT_NEAR(ledger.integration_loss, 0, 1e-12 * ledger.kinetic) << simulation.time();
  }
}

TEST(EnergyBalance, BodyOnASpringConservesEnergyToRoundOff) {
  // Rigid motion on four held points: exactly linear.
  Project project = test::rock_project(0, {{"swing", StageKind::dynamic, 1e-3, 500, {}}});
  project.solver.integrator = Integrator::generalized_alpha;
  project.solver.spectral_radius = 1;
  project.velocities = {{"B", Vec3(0, 0, 1), Vec3::Zero()}};
  const BlockSystem system = test::block_system({test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1))});
  Simulation simulation(project, system);
  EnergyLedger ledger;
  while (!simulation.finished()) ledger = simulation.step().energy;
  EXPECT_LT(std::abs(ledger.integration_loss), 1e-8 * 2600);
  EXPECT_LT(std::abs(ledger.remainder), 1e-8 * 2600);
}

TEST(EnergyBalance, ShakenBaseDoesTheWorkThatFrictionTakes) {
  Project project = test::rock_project(
      20, {{"settle", StageKind::static_, 0.01, 20, {}}, {"drag", StageKind::dynamic, 0.005, 200, {}}});
  project.constraints = {{"ground", std::nullopt, {0, 0, 0}, {{0.2, Vec3::Zero()}, {1.2, Vec3(3, 0, 0)}}}};
  BlockSystem system = test::cube_on_slab();
  system.blocks.push_back(test::box_block("wall", Vec3(1.01, -1, 0.001), Vec3(1.5, 2, 2), BodyKind::fixed));
  Simulation simulation(project, system);
  EnergyLedger ledger;
  while (!simulation.finished()) ledger = simulation.step().energy;
  ASSERT_TRUE(simulation.converged()) << simulation.failure();
  EXPECT_NEAR(ledger.friction_dissipated / (2600 * 9.81 * std::tan(20 * M_PI / 180) * 3), 1, 0.02);
  EXPECT_NEAR(ledger.constraint_work / ledger.friction_dissipated, 1, 0.05);
  EXPECT_LT(std::abs(ledger.remainder), 1e-8 * ledger.friction_dissipated);
}

}  // namespace
}  // namespace talus
