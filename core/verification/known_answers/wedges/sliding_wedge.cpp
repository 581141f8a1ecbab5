#include <algorithm>
#include <cmath>

#include "verification/known_answers/wedges/wedge_cases.hpp"

namespace talus {

namespace {

constexpr double first_look = 0.06, sliding_duration = 0.1;  // s
constexpr double tolerance = 1e-3;
constexpr double sliding_gravity = 9.81;  // m/s²

struct Slide {
  double acceleration = 0;  ///< m/s², from the first look on, along limit equilibrium's direction
  double normal = 0;        ///< mean of the planes' normal forces together, in weights of the wedge
};

Slide slide(const WedgeTest& test, const CaseOptions& options, Progress& progress) {
  const CaseScene scene = as_asked(wedge_test_scene(test, plaster_friction_angle, 1, sliding_duration), options);
  const Vec3 direction = test.equilibrium().direction;
  const double weight = plaster().density * scene.system.blocks[1].volume * scene.project.gravity.norm();

  double first_time = 0, first_speed = 0, time = 0, speed = 0, force = 0;
  int looks = 0;
  run_scene(scene, progress, [&](const Simulation& simulation, const StepReport&) {
    time = simulation.time();
    speed = block_motion(simulation.bodies(), 1).velocity.dot(direction);
    if (time < first_look * std::sqrt(options.scale)) {
      first_time = time;
      first_speed = speed;
      return true;
    }
    for (const ContactSample& contact : simulation.contacts()) force += contact.normal_force;
    ++looks;
    return true;
  });
  return {(speed - first_speed) / (time - first_time), force / looks / weight};
}

}  // namespace

CaseOutcome sliding_wedge_case(const CaseOptions& options, Progress& progress) {
  CaseOutcome outcome;
  for (const WedgeTest& test : wedge_tests()) {
    if (test.name() != "B2-60-0" && test.name() != "B1-60-30") continue;
    const WedgeEquilibrium equilibrium = test.equilibrium();
    const Slide computed = slide(test, options, progress);
    WedgeEquilibrium as_computed = equilibrium;
    as_computed.normal = computed.normal;
    outcome.findings.push_back({.quantity = test.name() + " acceleration",
                                .unit = "m/s²",
                                .expected = sliding_gravity * equilibrium.acceleration(plaster_friction_angle),
                                .computed = computed.acceleration,
                                .tolerance = tolerance});
    outcome.findings.push_back({.quantity = test.name() + " factor of safety from contact forces",
                                .unit = "",
                                .expected = equilibrium.factor(plaster_friction_angle),
                                .computed = as_computed.factor(plaster_friction_angle),
                                .tolerance = tolerance});
  }
  return outcome;
}

}  // namespace talus
