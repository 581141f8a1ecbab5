#include <cmath>

#include "model/stages.hpp"
#include "verification/known_answers/continuum/continuum_cases.hpp"
#include "verification/known_answers/support/scene.hpp"

namespace talus {

namespace {

constexpr double fall_gravity = 9.81, fall_time = 1, step = 0.01;

CaseScene falling_cube(Integrator integrator, Strain strain) {
  CaseScene scene;
  scene.project.gravity = {0, 0, -fall_gravity};
  scene.project.solver.integrator = integrator;
  scene.project.solver.strain = strain;
  scene.add_material({.name = "rock", .density = 2600, .young = 10e9, .poisson = 0.25});
  scene.add_block("cube", box_mesh({0, 0, 0}, {1, 1, 1}, 2, 2, 2), BodyKind::tetrahedra);
  scene.project.stages.push_back(dynamic_stage(step, fall_time));
  scene.add_monitor("middle", "cube", {0.5, 0.5, 0.5});
  return scene;
}

/// Depth fallen, at full scale [m].
double fallen(const CaseScene& scene, const CaseOptions& options, Progress& progress) {
  double depth = 0;
  run_scene(as_asked(scene, options), progress, [&](const Simulation& simulation, const StepReport&) {
    depth = -simulation.history().monitors.front().displacement.z() / options.scale;
    return true;
  });
  return depth;
}

CaseOutcome free_fall(const CaseOptions& options, Progress& progress) {
  CaseOutcome outcome;
  for (const Strain strain : {Strain::corotational, Strain::incremental})
    for (const Integrator integrator :
         {Integrator::newmark, Integrator::constant_acceleration, Integrator::generalized_alpha})
      outcome.findings.push_back({.quantity = "depth after 1 s, " + std::string(to_string(integrator)) + ", " +
                                              std::string(to_string(strain)) + " strain",
                                  .unit = "m",
                                  .expected = fall_gravity * fall_time * fall_time / 2,
                                  .computed = fallen(falling_cube(integrator, strain), options, progress),
                                  .tolerance = 1e-10});
  return outcome;
}

}  // namespace

std::vector<KnownCase> free_fall_cases() {
  return {{.name = "free_fall",
           .title = "A cube falls freely for a second",
           .source = "½gt²; constant acceleration is integrated exactly by every integrator",
           .of_any_body = true,
           .run = free_fall}};
}

}  // namespace talus
