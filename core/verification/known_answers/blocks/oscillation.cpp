#include "verification/known_answers/blocks/oscillation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.hpp"
#include "model/stages.hpp"
#include "verification/known_answers/support/recorded_run.hpp"

namespace talus {

namespace {

constexpr double g = 9.81;          // m/s²
constexpr double fine_step = 1e-5;  // s, of the rigid solutions that runs are held to
constexpr int static_steps = 20;
/// What steps of a few milliseconds may cost over a handful of slips.
constexpr double slip_tolerance = 0.01;

/// Shaking of 3 m/s² at 1 Hz, from rest.
struct Shaking {
  double acceleration = 3, frequency = 1;  ///< m/s², Hz
  double duration = 0;                     ///< s, whole cycles: the base is at rest again

  double omega() const { return 2 * std::numbers::pi * frequency; }
  double at(double t) const { return t < duration ? acceleration * std::sin(omega() * t) : 0; }
  double displacement(double t) const {
    const double shaken = std::min(t, duration);
    return acceleration / omega() * (shaken - std::sin(omega() * shaken) / omega());
  }
};

/// A block on a slab, whose shaking along `direction` starts after a static stage.
struct ShakenScene {
  CaseScene scene;
  Vec3 direction;
  Shaking shaking;
  double time_step = 0.002, length = 0;  ///< s

  double start() const { return static_steps * time_step; }
  void prepare() {
    scene.add_fixed_box("slab", Vec3(-2, -2, -1), Vec3(4, 2, 0));
    scene.add_box("block", Vec3(0, -0.5, 0), Vec3(1, 0.5, 0.5));
    Constraint base;
    base.block = "slab";
    for (int k = 0; k * time_step < length + time_step / 2; ++k)
      base.table.push_back({start() + k * time_step, shaking.displacement(k * time_step) * direction});
    scene.project.constraints = {base};
    scene.project.stages = {static_stage(time_step, static_steps), dynamic_stage(time_step, length)};
  }
  /// Displacement of the block along x relative to the slab, a number a step of the shaking [m].
  std::vector<double> run(const CaseOptions& options, Progress& progress) const {
    std::vector<double> displacement;
    for (const Snapshot& snapshot : record(scene, options, progress))
      if (snapshot.stage > 0)
        displacement.push_back(snapshot.blocks[1].displacement.x() -
                               shaking.displacement(snapshot.time - start()) * direction.x());
    return displacement;
  }
};

CaseOutcome shaken_flat(const CaseOptions& options, Progress& progress) {
  const double friction = 0.2;
  ShakenScene shaken{rock_scene(degrees(std::atan(friction))), Vec3(1, 0, 0), {.duration = 2}};
  shaken.length = 1.1;  // between the end of the second slip and the third
  shaken.prepare();
  const auto displacement = shaken.run(options, progress);
  const auto rigid = DrivenMass{[&](double t) { return -shaken.shaking.at(t); }, friction * g, friction * g}.path(
      shaken.length, fine_step);
  const auto slips = [](const std::vector<double>& path) {
    const double back = *std::min_element(path.begin(), path.end());
    return std::pair{-back, path.back() - back};
  };
  CaseOutcome outcome;
  outcome.findings.push_back({.quantity = "first slip, backwards",
                              .unit = "m",
                              .expected = slips(rigid).first,
                              .computed = slips(displacement).first,
                              .tolerance = slip_tolerance});
  outcome.findings.push_back({.quantity = "second slip, forwards",
                              .unit = "m",
                              .expected = slips(rigid).second,
                              .computed = slips(displacement).second,
                              .tolerance = slip_tolerance});
  return outcome;
}

CaseOutcome newmark(const CaseOptions& options, Progress& progress) {
  const double dip = 20, friction_angle = 30;
  ShakenScene shaken{
      rock_scene(friction_angle), Vec3(-std::cos(radians(dip)), 0, -std::sin(radians(dip))), {.duration = 3}};
  tilt(shaken.scene, dip);
  shaken.length = 4;
  shaken.prepare();
  // Equilibrium along and across the plane: ẍ = [a − g tan(φ − α)] · cos(φ − α) / cos φ for a towards the hill.
  const double spare = radians(friction_angle - dip);
  const double factor = std::cos(spare) / std::cos(radians(friction_angle));
  const double backward = factor * g * std::tan(radians(friction_angle + dip));  // never reached
  const DrivenMass rigid{[&](double t) { return factor * shaken.shaking.at(t); }, factor * g * std::tan(spare),
                         backward};
  CaseOutcome outcome;
  outcome.findings.push_back({.quantity = "slip in three cycles",
                              .unit = "m",
                              .expected = rigid.path(shaken.length, fine_step).back(),
                              .computed = shaken.run(options, progress).back(),
                              .tolerance = slip_tolerance});
  return outcome;
}

CaseOutcome oscillating_force(const CaseOptions& options, Progress& progress) {
  const double mass = 1, friction = 0.8, amplitude = 8, duration = 10, time_step = 0.001;
  CaseScene scene = rock_scene(degrees(std::atan(friction)));
  const Vec3 size(0.3, 0.3, 0.1);
  scene.project.materials[0].density = mass / size.prod();
  scene.project.materials[0].young = 1e9;  // light as the block is, rounding in 50 GPa would be felt
  scene.add_fixed_box("table", Vec3(-0.5, -0.5, -0.1), Vec3(0.8, 0.8, 0));
  scene.add_box("block", Vec3::Zero(), size);
  PointLoad load;
  load.block = "block";
  load.at = size / 2;
  // Before, the force has stood a little below what friction bears: a mass that rests feels no blow when it starts.
  const double start = static_steps * time_step;
  load.table = {{start, Vec3(0.99 * friction * mass * g, 0, 0)}};
  for (int k = 1; k * time_step < duration + time_step / 2; ++k)
    load.table.push_back({start + k * time_step, Vec3(amplitude * std::cos(k * time_step), 0, 0)});
  scene.project.loads = {load};
  scene.project.stages = {static_stage(time_step, static_steps), dynamic_stage(time_step, duration)};
  const auto snapshots = record(scene, options, progress);
  const DrivenMass rigid{[=](double t) { return amplitude / mass * std::cos(t); }, friction * g, friction * g};
  CaseOutcome outcome;
  outcome.findings.push_back({.quantity = "displacement after 10 s",
                              .unit = "m",
                              .expected = rigid.path(duration, fine_step).back(),
                              .computed = snapshots.back().blocks[1].displacement.x(),
                              .tolerance = slip_tolerance});
  return outcome;
}

}  // namespace

std::vector<double> DrivenMass::path(double duration, double time_step) const {
  std::vector<double> displacement{0};
  double position = 0, velocity = 0;
  const long steps = std::lround(duration / time_step);
  for (long k = 0; k < steps; ++k) {
    const double driven = drive((static_cast<double>(k) + 0.5) * time_step);
    double acceleration = 0;
    if (velocity > 0 || (velocity == 0 && driven > forward)) acceleration = driven - forward;
    if (velocity < 0 || (velocity == 0 && driven < -backward)) acceleration = driven + backward;
    const double next = velocity + acceleration * time_step;
    const bool stops = velocity * next < 0;
    position += stops ? -velocity * velocity / (2 * acceleration) : (velocity + next) / 2 * time_step;
    velocity = stops ? 0 : next;
    displacement.push_back(position);
  }
  return displacement;
}

std::vector<KnownCase> oscillation_cases() {
  return {{.name = "shaken_base",
           .title = "A block on a flat base shaken at 3 m/s² and 1 Hz, μ = 0.2",
           .source = "v = (A/ω)(cos ωt₁ − cos ωt) − μg(t − t₁)",
           .of_any_body = true,
           .run = shaken_flat},
          {.name = "newmark_block",
           .title = "A block on a shaken incline of 20°, φ = 30°",
           .source = "Newmark 1965, with the base's acceleration horizontal",
           .of_any_body = true,
           .run = newmark},
          {.name = "oscillating_force",
           .title = "A block on dry friction under a force of 8 cos t N",
           .source = "Potra, Anitescu, Gavrea & Trinkle 2006; rigid mass, integrated",
           .of_any_body = true,
           .run = oscillating_force}};
}

}  // namespace talus
