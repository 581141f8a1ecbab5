#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/stages.hpp"
#include "verification/known_answers/continuum/continuum_cases.hpp"
#include "verification/known_answers/continuum/free_rotation.hpp"
#include "verification/known_answers/support/convergence.hpp"
#include "verification/known_answers/support/scene.hpp"

namespace talus {

namespace {

const Material hard_rock{.name = "rock", .density = 2500, .young = 50e9, .poisson = 0.25};
constexpr double turn = 2 * std::numbers::pi;

/// A cube that turns about z through its middle at 10 rad/s.
CaseScene spinning_cube(Strain strain, Integrator integrator, double step_angle, int steps) {
  constexpr double angular_velocity = 10;
  CaseScene scene;
  scene.project.gravity.setZero();
  scene.project.solver.strain = strain;
  scene.project.solver.integrator = integrator;
  scene.project.solver.spectral_radius = 1;
  scene.add_material(hard_rock);
  scene.add_block("cube", box_mesh({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, 1, 1, 1), BodyKind::tetrahedra);
  scene.project.velocities.push_back({.block = "cube", .angular = {0, 0, angular_velocity}});
  const double step = step_angle / angular_velocity;
  scene.project.stages.push_back(dynamic_stage(step, steps * step));
  return scene;
}

/// How a block has turned and grown.
struct Spin {
  double turns = 0;
  long steps = 0;
  double change = 0;          ///< of the volume, relative, at the end
  double largest_change = 0;  ///< the largest after the first turn, beyond what the spin itself widens it by
  double growth = 0;          ///< Π (1 + θ²) − 1 over all steps, with the tangent of the step's angle for θ
  double spin_left = 0;       ///< angular momentum at the end over that at the start
};

/// Relative change of volume of an elastic body that spins steadily: by the virial theorem the volume integral of the
/// stress's trace is twice the kinetic energy, in tetrahedra too, since x itself is a displacement they can take.
double centrifugal_change(const CaseScene& scene, double kinetic_energy) {
  if (scene.system.blocks.front().body == BodyKind::rigid) return 0;
  const Material& rock = scene.project.materials.front();
  return (1 - 2 * rock.poisson) / rock.young * 2 * kinetic_energy / scene.system.blocks.front().volume;
}

Spin spin(const CaseScene& full_size, double turns, const CaseOptions& options, Progress& progress) {
  const CaseScene scene = as_asked(full_size, options);
  const double omega = scene.project.velocities.front().angular.z(), side = options.scale;
  const double momentum = hard_rock.density * std::pow(side, 5) / 6 * omega;
  const std::size_t last = scene.system.blocks.front().mesh.nodes.size() - 1;
  const auto arm_of = [last](const std::vector<Vec3>& x) { return Vec3(x[last] - x[0]); };
  Vec3 arm = arm_of(scene.system.blocks.front().mesh.nodes);
  Spin result;
  run_scene(scene, progress, [&](const Simulation& simulation, const StepReport& report) {
    const BodySet& bodies = simulation.bodies();
    const Vec3 now = arm_of(bodies.nodes.position);
    const double angle = std::atan2(arm.x() * now.y() - arm.y() * now.x(), arm.x() * now.x() + arm.y() * now.y());
    arm = now;
    ++result.steps;
    result.turns += angle / turn;
    result.growth = (1 + result.growth) * (1 + std::tan(angle) * std::tan(angle)) - 1;
    result.change = block_motion(bodies, 0).relative_volume_change;
    result.spin_left = angular_momentum(bodies).z() / momentum;
    const double beyond = result.change - centrifugal_change(scene, report.energy.kinetic);
    if (result.turns > 1) result.largest_change = std::max(result.largest_change, std::abs(beyond));
    return result.turns < turns;
  });
  return result;
}

CaseOutcome spinning_block(const CaseOptions& options, Progress& progress) {
  constexpr int limit = 1000000;
  constexpr double angle = 0.01;    // rad a step at first
  constexpr double settled = 1e-9;  // forces balance to this fraction of mω²r: angular momentum to it a radian
  const double turns = options.thorough ? 100 : 10;
  const std::string in_turns = " in " + short_number(turns) + " turns";
  CaseOutcome outcome;
  CaseTable table{"A block spins freely",
                  {"strain", "integrator", "rad a step", "turns", "steps", "change of volume", "angular momentum left"},
                  {}};
  const auto run = [&](Strain strain, Integrator integrator, double step_angle, double wanted) {
    const Spin found = spin(spinning_cube(strain, integrator, step_angle, limit), wanted, options, progress);
    table.rows.push_back({std::string(to_string(strain)), std::string(to_string(integrator)), short_number(step_angle),
                          short_number(found.turns), std::to_string(found.steps), short_number(found.change),
                          short_number(found.spin_left)});
    return found;
  };
  const bool rigid = options.body == BodyKind::rigid;  // its angular momentum stays whatever the integrator
  const Spin steady = run(Strain::corotational, Integrator::newmark, angle, turns);
  const Spin lasting = run(Strain::corotational, Integrator::generalized_alpha, angle, turns);
  outcome.findings.push_back({.quantity = "angular momentum left" + in_turns + ", newmark",
                              .unit = "",
                              .expected = 1,
                              .computed = steady.spin_left,
                              .tolerance = 1e-3});
  const Spin grown = run(Strain::incremental, Integrator::constant_acceleration, angle, 1);
  outcome.findings.push_back({.quantity = "change of volume" + in_turns + ", newmark",
                              .unit = "",
                              .computed = steady.largest_change,
                              .tolerance = 1e-10,
                              .absolute = true});
  outcome.findings.push_back({.quantity = "change of volume" + in_turns + ", generalized-alpha",
                              .unit = "",
                              .computed = lasting.largest_change,
                              .tolerance = 1e-10,
                              .absolute = true,
                              .reported = true});
  outcome.findings.push_back({.quantity = "angular momentum left" + in_turns + ", generalized-alpha",
                              .unit = "",
                              .expected = 1,
                              .computed = lasting.spin_left,
                              .tolerance = turns * turn * settled});
  outcome.findings.push_back({.quantity = "growth in a turn at 0.01 rad a step, incremental strain",
                              .unit = "",
                              .expected = rigid ? 0 : grown.growth,
                              .computed = grown.change,
                              .tolerance = 1e-3,
                              .absolute = rigid});
  outcome.tables.push_back(table);
  outcome.remarks.push_back(
      "Generalized-alpha takes elastic forces on the chord between two positions, which is shorter than the block by "
      "θ²/8 at a step's rotation θ: the volume swings by up to θ²/2. Newmark takes strains at the end of the step and "
      "their forces along its mean rotation, and keeps the volume and the spin.");
  return outcome;
}

/// Box 1 × 2 × 3 m, turning about its middle axis y with a little of the two others. It widens by 1e-6, so that it is
/// as good as rigid, and its elastic forces are not so much larger than those of the spin that their rounding shows.
CaseScene tumbling_box(double step, double duration) {
  CaseScene scene;
  scene.project.gravity.setZero();
  scene.project.solver.integrator = Integrator::generalized_alpha;
  scene.project.solver.spectral_radius = 1;
  scene.add_material({.name = "soft rock", .density = 2500, .young = 5e9, .poisson = 0.25});
  scene.add_block("box", box_mesh({-0.5, -1, -1.5}, {0.5, 1, 1.5}, 1, 2, 3), BodyKind::tetrahedra);
  scene.project.velocities.push_back({.block = "box", .angular = {0.01, 1, 0.01}});
  scene.project.stages.push_back(dynamic_stage(step, duration));
  return scene;
}

/// What a tumbling box did, at full scale.
struct Tumble {
  std::vector<double> crossings;                ///< s, of the angular velocity about the middle axis
  double energy_drift = 0, momentum_drift = 0;  ///< relative, largest
};

Tumble tumble(double step, double duration, const CaseOptions& options, Progress& progress) {
  Tumble result;
  const double root = std::sqrt(options.scale);
  Vec3 first_momentum = Vec3::Zero();
  double first_energy = 0, last_share = 1, last_time = 0;
  run_scene(as_asked(tumbling_box(step, duration), options), progress,
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
  CaseOutcome outcome;
  CaseTable table{"Drift in 40 s of torque-free spin", {"step [s]", "angular momentum", "energy", "order"}, {}};
  Tumble found;
  for (const double step : options.thorough ? std::vector{0.01, 0.005, 0.0025} : std::vector{0.01}) {
    const double coarse_drift = found.energy_drift;
    found = tumble(step, 40, options, progress);
    table.rows.push_back({short_number(step), short_number(found.momentum_drift), short_number(found.energy_drift),
                          coarse_drift > 0 ? short_number(observed_order(coarse_drift, found.energy_drift)) : ""});
  }
  const auto crossing = [&](std::size_t i) { return i < found.crossings.size() ? found.crossings[i] : 0; };
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
  outcome.tables.push_back(table);
  outcome.remarks.push_back(
      "Generalized-alpha takes elastic forces on the chord between two positions, which is shorter than the block by "
      "θ²/8 at a step's rotation θ: the block swings about that strain, with energy of the order of its fourth power.");
  return outcome;
}

}  // namespace

std::vector<KnownCase> spin_cases() {
  return {{.name = "spinning_block",
           .title = "A block spins freely: its volume",
           .source = "a rotation changes no volume; incremental strain: factor 1 + θ² a step",
           .thinned = true,
           .of_any_body = true,
           .run = spinning_block},
          {.name = "middle_axis",
           .title = "Torque-free spin of a box about its middle axis",
           .source = "Euler's equations",
           .thinned = true,
           .of_any_body = true,
           .run = middle_axis}};
}

}  // namespace talus
