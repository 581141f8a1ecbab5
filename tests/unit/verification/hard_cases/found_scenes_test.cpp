#include <gtest/gtest.h>

#include <algorithm>

#include "solve/simulation.hpp"
#include "verification/hard_cases/scenes/all_hard_cases.hpp"

namespace talus {
namespace {

CaseScene scene_of(const std::string& name) {
  const std::vector<HardCase> all = hard_cases();
  return std::find_if(all.begin(), all.end(), [&](const HardCase& one) { return one.name == name; })->build();
}

struct Effort {
  double iterations_per_step;
  int cuts;
};

Effort effort_of(const CaseScene& scene, int steps) {
  Simulation simulation(scene.project, scene.system);
  int iterations = 0, cuts = 0;
  for (int k = 0; k < steps; ++k) {
    const StepReport report = simulation.step();
    iterations += report.iterations;
    cuts += report.cuts;
  }
  EXPECT_TRUE(simulation.converged()) << simulation.failure();
  return {static_cast<double>(iterations) / steps, cuts};
}

TEST(FoundScenes, StaticStepsOfACreepingSlopeTakeFewIterationsAmongSpringsThatTheyCanFollow) {
  CaseScene scene = scene_of("slope_59_static_slow");
  const Effort followed = effort_of(scene, 60);
  EXPECT_LT(followed.iterations_per_step, 15);
  EXPECT_EQ(followed.cuts, 0);
  scene.project.solver.effects.followed_springs = Switch::off;
  EXPECT_GT(effort_of(scene, 5).iterations_per_step, 10 * followed.iterations_per_step);
}

}  // namespace
}  // namespace talus
