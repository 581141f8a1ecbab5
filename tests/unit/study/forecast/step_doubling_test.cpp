#include "study/forecast/step_doubling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "study/forecast/forecast.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

/// A free elastic bar of 1 m that is pulled at both ends by a force that grows from zero, of one period a second. It
/// stretches as one, by 1e-5·(t − sin(ωt)/ω): all of it is strain, and its centroid stands still.
Project bar(Integrator integrator, double time_step) {
  const double omega = 2 * std::numbers::pi, density = 2600, young = density * omega * omega / 12;
  Project project;
  project.gravity = Vec3::Zero();
  project.materials = {{"rock", density, young, 0}};
  project.stages = {{"pull", StageKind::dynamic, time_step, static_cast<int>(std::lround(1.4 / time_step)), {}}};
  project.solver.integrator = integrator;
  for (const int side : {0, 1}) {
    PointLoad load{"bar", Vec3(0.5, 0.5, side), Vec3::Zero()};
    load.table = {{0, Vec3::Zero()}, {2, (2 * side - 1) * 4e-5 * young * Vec3::UnitZ()}};
    project.loads.push_back(load);
  }
  return project;
}

BlockSystem bar_alone(BodyKind body) {
  return test::block_system({test::box_block("bar", Vec3(0, 0, 0), Vec3(1, 1, 1), body)});
}

double stretch_at(double time) {
  const double omega = 2 * std::numbers::pi;
  return 1e-5 * (time - std::sin(omega * time) / omega);
}

/// The largest difference from the known answer at the quarters, over the longest displacement of an end.
double measured(const Project& project, const BlockSystem& system) {
  Simulation simulation(project, system);
  double apart = 0, longest = 0;
  for (int k = 1, steps = *project.stages[0].steps; k <= steps; ++k) {
    const double time = simulation.step().time;
    if (4 * k % steps != 0) continue;
    const double way = simulation.frame(0).displacement[7].z();
    apart = std::max(apart, std::abs(way - stretch_at(time)));
    longest = std::max(longest, std::abs(way));
  }
  return apart / longest;
}

TEST(StepDoubling, KnowsTheErrorOfAVibrationByItsOrder) {
  NoProgress progress;
  const BlockSystem system = bar_alone(BodyKind::affine);
  for (const auto& [integrator, order] : {std::pair(Integrator::newmark, 1), {Integrator::generalized_alpha, 2}}) {
    double coarser = 0;
    for (const double time_step : {0.005, 0.0025}) {
      const Project project = bar(integrator, time_step);
      const auto error = error_by_step_doubling(project, system, 1e3, progress);
      ASSERT_TRUE(error);
      EXPECT_NEAR(*error / measured(project, system), 1, 0.1) << to_string(integrator) << ' ' << time_step;
      if (coarser > 0) {
        EXPECT_NEAR(std::log2(coarser / *error), order, 0.1) << to_string(integrator);
      }
      coarser = *error;
    }
  }
}

TEST(StepDoubling, IsWhatAForecastSaysOfARunThatIsShort) {
  NoProgress progress;
  const BlockSystem system = bar_alone(BodyKind::tetrahedra);
  const Project project = bar(Integrator::newmark, 0.0025);
  const auto error = error_by_step_doubling(project, system, 1e3, progress);
  ASSERT_TRUE(error);
  EXPECT_GT(*error, 1e-3);
  EXPECT_EQ(forecast(project, system, 1e3, progress).error, error);
}

TEST(StepDoubling, SaysNothingOfWhatItCannotAfford) {
  NoProgress progress;
  EXPECT_FALSE(error_by_step_doubling(bar(Integrator::newmark, 1e-4), bar_alone(BodyKind::affine), 1e-4, progress));
}

}  // namespace
}  // namespace talus
