#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/block_scene.hpp"
#include "cases/continuum_parts.hpp"
#include "cases/convergence.hpp"
#include "cases/free_rotation.hpp"

namespace talus {

namespace {

const Material hard_rock{.name = "rock", .density = 2500, .young = 50e9, .poisson = 0.25};
constexpr double turn = 2 * std::numbers::pi;

/// A cube that turns about z through its middle at 0.01 rad/s, so slowly that it widens by 1e-12 only.
Scene spinning_cube(Strain strain, Integrator integrator, double step_angle, int steps) {
  constexpr double angular_velocity = 0.01;
  Scene scene;
  scene.project.gravity.setZero();
  scene.project.solver.strain = strain;
  scene.project.solver.integrator = integrator;
  scene.project.solver.spectral_radius = 1;
  scene.add_material(hard_rock);
  scene.add_block("cube", box_mesh({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, 1, 1, 1), BodyKind::tetrahedra);
  scene.project.velocities.push_back({.block = "cube", .angular = {0, 0, angular_velocity}});
  const double step = step_angle / angular_velocity;
  scene.project.stages.push_back(motion(step, steps * step));
  return scene;
}

/// How a block has turned and grown.
struct Spin {
  double turns = 0;
  long steps = 0;
  double largest_change = 0;   ///< of the volume, relative, over all steps
  double last_change = 0;      ///< at the end
  double growth_by_steps = 1;  ///< Π (1 + θ²) over all steps, tan of the step's angle for θ
  double spin_left = 0;        ///< angular momentum at the end over that at the start
};

Spin spin(const Scene& scene, double turns, double scale, Progress& progress) {
  Spin result;
  double angle = 0, initial_momentum = 0;
  Vec3 arm = Vec3::Zero();
  const Scene scaled_scene = scaled(scene, scale);
  run_scene(scaled_scene, progress, [&](const Simulation& simulation, const StepReport&) {
    const BodySet& bodies = simulation.bodies();
    const auto arm_at = [&](const std::vector<Vec3>& x) { return Vec3(x.back() - x.front()); };
    const Vec3 now = arm_at(bodies.nodes.position);
    if (result.steps++ == 0) {
      arm = arm_at(bodies.nodes.reference);
      const double omega = scaled_scene.project.velocities[0].angular.z(), side = scale;
      initial_momentum = hard_rock.density * std::pow(side, 5) / 6 * omega;
    }
    const double step_angle = std::atan2(arm.x() * now.y() - arm.y() * now.x(), arm.x() * now.x() + arm.y() * now.y());
    arm = now;
    angle += step_angle;
    result.turns = angle / turn;
    result.growth_by_steps *= 1 + std::tan(step_angle) * std::tan(step_angle);
    result.last_change = block_motion(bodies, 0).relative_volume_change;
    result.largest_change = std::max(result.largest_change, std::abs(result.last_change));
    result.spin_left = angular_momentum(bodies).z() / initial_momentum;
    return result.turns < turns;
  });
  return result;
}

CaseOutcome spinning_block(const CaseOptions& options, Progress& progress) {
  constexpr int limit = 1000000;
  constexpr double turns = 100;
  CaseOutcome outcome;
  CaseTable table{
      "A block spins freely",
      {"strain", "integrator", "rad a step", "turns", "steps", "largest change of volume", "angular momentum left"},
      {}};
  const auto run = [&](Strain strain, Integrator integrator, double angle, double wanted_turns) {
    const Spin found = spin(spinning_cube(strain, integrator, angle, limit), wanted_turns, options.scale, progress);
    table.rows.push_back({std::string(to_string(strain)), std::string(to_string(integrator)), short_number(angle),
                          short_number(found.turns), std::to_string(found.steps), short_number(found.largest_change),
                          short_number(found.spin_left)});
    return found;
  };
  for (const Integrator integrator : {Integrator::newmark, Integrator::generalized_alpha}) {
    const Spin found = run(Strain::corotational, integrator, 0.02, turns);
    const std::string with = ", " + std::string(to_string(integrator));
    outcome.findings.push_back({.quantity = "change of volume in 100 turns, corotational strain" + with,
                                .unit = "",
                                .computed = found.largest_change,
                                .tolerance = 1e-10,
                                .absolute = true});
    if (integrator == Integrator::generalized_alpha)
      outcome.findings.push_back({.quantity = "angular momentum left after 100 turns" + with,
                                  .unit = "",
                                  .expected = 1,
                                  .computed = found.spin_left,
                                  .tolerance = 1e-8});
  }
  const Spin grown = run(Strain::incremental, Integrator::constant_acceleration, 0.01, 1);
  outcome.findings.push_back({.quantity = "growth in a turn at 0.01 rad a step, incremental strain",
                              .unit = "",
                              .expected = grown.growth_by_steps - 1,
                              .computed = grown.last_change,
                              .tolerance = 1e-3});
  outcome.tables.push_back(table);
  return outcome;
}

/// Box 1 × 2 × 3 m, turning about its middle axis y with a little of the two others.
Scene tumbling_box(double step, double duration) {
  Scene scene;
  scene.project.gravity.setZero();
  scene.project.solver.integrator = Integrator::generalized_alpha;
  scene.project.solver.spectral_radius = 1;
  scene.add_material(hard_rock);
  scene.add_block("box", box_mesh({-0.5, -1, -1.5}, {0.5, 1, 1.5}, 1, 2, 3), BodyKind::tetrahedra);
  scene.project.velocities.push_back({.block = "box", .angular = {0.01, 1, 0.01}});
  scene.project.stages.push_back(motion(step, duration));
  return scene;
}

/// What a tumbling box did, at full scale.
struct Tumble {
  std::vector<double> crossings;                ///< s, of the angular velocity about the middle axis
  double energy_drift = 0, momentum_drift = 0;  ///< relative, largest
};

Tumble tumble(double step, double duration, double scale, Progress& progress) {
  Tumble result;
  const double root = std::sqrt(scale);
  Vec3 first_momentum = Vec3::Zero();
  double first_energy = 0, last_share = 1, last_time = 0;
  run_scene(scaled(tumbling_box(step, duration), scale), progress,
            [&](const Simulation& simulation, const StepReport& report) {
              const BodySet& bodies = simulation.bodies();
              const Vec3 momentum = angular_momentum(bodies);
              const double energy = report.energy.kinetic + report.energy.elastic, time = simulation.time() / root;
              // ω₂ is zero when the angular momentum is square to the body's second axis: nodes run along x, y, z.
              const auto& x = bodies.nodes.position;
              const double share = momentum.normalized().dot((x[4] - x[0]).normalized());
              if (first_energy == 0) {
                first_energy = energy;
                first_momentum = momentum;
              } else if (last_share * share < 0) {
                result.crossings.push_back(last_time + (time - last_time) * last_share / (last_share - share));
              }
              result.energy_drift = std::max(result.energy_drift, std::abs(energy / first_energy - 1));
              result.momentum_drift =
                  std::max(result.momentum_drift, (momentum - first_momentum).norm() / first_momentum.norm());
              last_share = share;
              last_time = time;
              return true;
            });
  return result;
}

CaseOutcome middle_axis(const CaseOptions& options, Progress& progress) {
  const Vec3 moments(4 + 9, 9 + 1, 1 + 4);
  const std::vector<double> expected = zero_crossings(moments, {0.01, 1, 0.01}, 1, 2);
  const Tumble found = tumble(0.01, 40, options.scale, progress);
  const auto crossing = [&](std::size_t i) { return i < found.crossings.size() ? found.crossings[i] : 0; };
  CaseOutcome outcome;
  outcome.findings.push_back({.quantity = "first moment without spin about the middle axis",
                              .unit = "s",
                              .expected = expected[0],
                              .computed = crossing(0),
                              .tolerance = 1e-3});
  outcome.findings.push_back({.quantity = "time until the next",
                              .unit = "s",
                              .expected = expected[1] - expected[0],
                              .computed = crossing(1) - crossing(0),
                              .tolerance = 1e-3});
  outcome.findings.push_back({.quantity = "drift of angular momentum in 40 s",
                              .unit = "",
                              .computed = found.momentum_drift,
                              .tolerance = 1e-8,
                              .absolute = true});
  outcome.findings.push_back({.quantity = "drift of energy in 40 s",
                              .unit = "",
                              .computed = found.energy_drift,
                              .tolerance = 1e-8,
                              .absolute = true,
                              .reported = true});
  return outcome;
}

}  // namespace

std::vector<KnownCase> spin_cases() {
  return {{.name = "spinning_block",
           .title = "A block spins freely: its volume",
           .source = "a rotation changes no volume; incremental strain: factor 1 + θ² a step",
           .run = spinning_block},
          {.name = "middle_axis",
           .title = "Torque-free spin of a box about its middle axis",
           .source = "Euler's equations",
           .run = middle_axis}};
}

}  // namespace talus
