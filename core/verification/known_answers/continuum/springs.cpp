#include <cmath>
#include <numbers>

#include "model/stages.hpp"
#include "verification/known_answers/continuum/continuum_cases.hpp"
#include "verification/known_answers/support/scene.hpp"

namespace talus {

namespace {

constexpr double spring_gravity = 9.81, mass = 1000, stiffness = 1e8;

/// A cube of 1 m³ and 1 t, much stiffer than the joint it stands on: 1 m² of 1e8 Pa/m.
CaseScene cube_on_spring(double drop, Integrator integrator) {
  CaseScene scene;
  scene.project.gravity = {0, 0, -spring_gravity};
  scene.project.solver.integrator = integrator;
  scene.project.solver.spectral_radius = 1;
  scene.add_material({.name = "stiff", .density = mass, .young = 1e12, .poisson = 0.25});
  Joint spring;
  spring.name = "spring";
  spring.normal_stiffness = stiffness;
  scene.add_joint(spring);
  scene.add_block("ground", box_mesh({-1, -1, -1}, {2, 2, 0}, 1, 1, 1), BodyKind::fixed);
  scene.add_block("cube", box_mesh({0, 0, drop}, {1, 1, 1 + drop}, 1, 1, 1), BodyKind::tetrahedra);
  scene.add_monitor("middle", "cube", {0.5, 0.5, 0.5 + drop});
  return scene;
}

double normal_force(const Simulation& simulation) {
  double sum = 0;
  for (const ContactSample& contact : simulation.contacts()) sum += contact.normal_force;
  return sum;
}

/// What a bounce was like, at full scale.
struct Bounce {
  double begin = 0, end = 0;  ///< s
  double peak_force = 0;      ///< N
  double rebound = 0;         ///< m/s, when contact ends
  double energy_loss = 0;     ///< integration loss over the highest kinetic energy
};

Bounce bounce(const CaseScene& scene, const CaseOptions& options, Progress& progress) {
  const double scale = options.scale, root = std::sqrt(scale);
  Bounce result;
  double last_force = 0, last_time = 0, kinetic = 0;
  run_scene(as_asked(scene, options), progress, [&](const Simulation& simulation, const StepReport& report) {
    const double force = normal_force(simulation) / (scale * scale * scale), time = simulation.time() / root;
    // The force grows and falls linearly at both ends: its zero lies on the line through two samples.
    const double zero = last_time - last_force * (time - last_time) / (force - last_force);
    const bool over = last_force > 0 && force == 0;
    if (last_force > 0 && force > last_force && result.begin == 0) result.begin = zero;
    if (last_force > force && force > 0) result.end = zero;
    result.peak_force = std::max(result.peak_force, force);
    kinetic = std::max(kinetic, report.energy.kinetic);
    result.energy_loss = report.energy.integration_loss / kinetic;
    result.rebound = simulation.history().monitors[0].velocity.z() / root;
    last_force = force;
    last_time = time;
    return !over;
  });
  return result;
}

/// mẍ = mg − kx from x = 0 with v₀: contact lasts (π + 2 atan(g/(v₀ω)))/ω, and the force comes to mg + √((mg)² +
/// kmv₀²).
CaseOutcome elastic_impact(const CaseOptions& options, Progress& progress) {
  constexpr double drop = 1, step = 5e-6, weight = mass * spring_gravity;
  const double speed = std::sqrt(2 * spring_gravity * drop), omega = std::sqrt(stiffness / mass);
  const double duration = (std::numbers::pi + 2 * std::atan(spring_gravity / (speed * omega))) / omega;
  const double force = weight + std::sqrt(weight * weight + stiffness * mass * speed * speed);
  CaseOutcome outcome;
  for (const Integrator integrator : {Integrator::generalized_alpha, Integrator::constant_acceleration}) {
    CaseScene scene = cube_on_spring(drop, integrator);
    scene.project.stages.push_back(dynamic_stage(1e-3, 0.45));
    scene.project.stages.push_back(dynamic_stage(step, 0.015));
    const Bounce found = bounce(scene, options, progress);
    const std::string with = ", " + std::string(to_string(integrator));
    const bool paper = integrator == Integrator::constant_acceleration;
    outcome.findings.push_back({.quantity = "time in contact" + with,
                                .unit = "s",
                                .expected = duration,
                                .computed = found.end - found.begin,
                                .tolerance = 2e-3,
                                .reported = paper});
    outcome.findings.push_back({.quantity = "largest force" + with,
                                .unit = "N",
                                .expected = force,
                                .computed = found.peak_force,
                                .tolerance = 2e-3,
                                .reported = paper});
    outcome.findings.push_back({.quantity = "speed of rebound" + with,
                                .unit = "m/s",
                                .expected = speed,
                                .computed = found.rebound,
                                .tolerance = 2e-3,
                                .reported = paper});
    outcome.findings.push_back({.quantity = "integration loss over the energy that moved" + with,
                                .unit = "",
                                .expected = -std::expm1(-std::numbers::pi * omega * step / 2),
                                .computed = found.energy_loss,
                                .tolerance = 0.05});
  }
  outcome.remarks.push_back(
      "Contact forces are taken at the end of the step, which damps by ωΔ/4 with every integrator: each bounce loses "
      "πωΔ/2 of its energy.");
  outcome.remarks.push_back("Without weight during contact it is 9.93 ms and 1.40 MN; with it 9.98 ms and 1.41 MN.");
  return outcome;
}

/// The cube settles by mg/k; then half its weight is added, and it swings about 1.5 mg/k without leaving the joint.
CaseOutcome block_on_springs(const CaseOptions& options, Progress& progress) {
  constexpr double settled = mass * spring_gravity / stiffness, step = 1e-4, duration = 0.21;
  CaseScene scene = cube_on_spring(0, Integrator::generalized_alpha);
  scene.project.stages.push_back(static_stage(1, 4));
  Stage swing = dynamic_stage(step, duration);
  swing.loads = {{.block = "cube", .at = {0.5, 0.5, 0.5}, .force = {0, 0, -mass * spring_gravity / 2}, .table = {}}};
  scene.project.stages.push_back(swing);

  const double scale = options.scale, root = std::sqrt(scale);
  double rest = 0, first = 0, last = 0, last_depth = 0, last_time = 0;
  int passages = 0;
  run_scene(as_asked(scene, options), progress, [&](const Simulation& simulation, const StepReport&) {
    const HistoryRow row = simulation.history();
    const double depth = -row.monitors[0].displacement.z() / scale / settled, time = row.time / root;
    if (row.stage == 0) {
      rest = depth;
    } else if (last_depth < 1.5 && depth >= 1.5) {
      last = last_time + (time - last_time) * (1.5 - last_depth) / (depth - last_depth);
      if (passages++ == 0) first = last;
    }
    last_depth = depth;
    last_time = time;
    return true;
  });
  CaseOutcome outcome;
  outcome.findings.push_back(
      {.quantity = "settlement", .unit = "m", .expected = settled, .computed = rest * settled, .tolerance = 1e-4});
  outcome.findings.push_back({.quantity = "frequency",
                              .unit = "Hz",
                              .expected = std::sqrt(stiffness / mass) / (2 * std::numbers::pi),
                              .computed = (passages - 1) / (last - first),
                              .tolerance = 2e-3});
  return outcome;
}

}  // namespace

std::vector<KnownCase> spring_cases() {
  return {{.name = "elastic_impact",
           .title = "A block of 1 t falls 1 m on a joint of 1e8 N/m",
           .source = "oscillator with weight: (π + 2 atan(g/v₀ω))/ω, mg + √((mg)² + kmv₀²)",
           .of_any_body = true,
           .run = elastic_impact},
          {.name = "block_on_springs",
           .title = "A block settles and swings on its joint",
           .source = "u = mg/(kA), f = √(kA/m)/2π",
           .of_any_body = true,
           .run = block_on_springs}};
}

}  // namespace talus
