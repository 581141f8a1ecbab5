#include "verification/known_answers/blocks/block_cases.hpp"

#include <algorithm>
#include <cmath>

#include "model/stages.hpp"
#include "verification/known_answers/support/recorded_run.hpp"

namespace talus {

namespace {

/// A column of 1 m by 4 m that rocks about its edges without slipping (Housner 1963).
struct RockingColumn {
  double width = 1, height = 4, tilt = 0;  ///< m, m, rad at the start
  static constexpr double g = 9.81;

  double slope() const { return std::atan(width / height); }  ///< α, the tilt at which it stands on its edge
  double p_squared() const { return 3 * g / (2 * std::hypot(width, height)); }  ///< 3g/4R, 1/s²

  /// Time from rest at the tilt to upright [s]: θ̈ = −p² sin(α − θ), integrated. For slender columns it is
  /// acosh(1/(1 − θ₀/α))/p.
  double quarter_period() const {
    const double step = 1e-5;
    double angle = tilt, speed = 0, time = 0;
    while (angle > 0) {
      speed -= step * p_squared() * std::sin(slope() - (angle + step / 2 * speed));
      angle += step * speed;
      time += step;
    }
    return time - angle / speed;
  }
  /// Kinetic energy of rotation left after an impact that brings the other edge down for good, of that before.
  double energy_kept() const { return std::pow(1 - 1.5 * std::pow(std::sin(slope()), 2), 2); }
  /// Of the energy that it had upright before the impact, what it has at `angle` beyond upright when it turns at
  /// `speed` [rad/s]. By mgR the first is cos(α − θ₀) − cos α, the kinetic energy θ̇²/2p².
  double energy(double angle, double speed) const {
    return (std::cos(slope() - angle) - std::cos(slope()) + speed * speed / (2 * p_squared())) /
           (std::cos(slope() - tilt) - std::cos(slope()));
  }

  CaseScene scene(double time_step, double duration) const {
    CaseScene scene = rock_scene(45);
    // What an impact keeps hangs on when in its step it comes: at standard two scales differ by 5e-6 of it.
    scene.project.solver.tolerance = reference_tolerance.value;
    scene.project.joints[0].restitution = 0;  // the edge that comes down stays there
    scene.add_fixed_box("floor", Vec3(-4, -2, -1), Vec3(4, 2, 0));
    std::array<Vec3, 8> corners;
    for (int k = 0; k < 8; ++k) {
      const double x = k & 1 ? 0 : -width, y = k & 2 ? 0.5 : -0.5, z = k & 4 ? height : 0;
      corners[k] = Vec3(x * std::cos(tilt) + z * std::sin(tilt), y, z * std::cos(tilt) - x * std::sin(tilt));
    }
    scene.add_block("column", hexahedron_mesh(corners, 1, 1, 2), BodyKind::tetrahedra);
    scene.project.stages = {dynamic_stage(time_step, duration)};
    return scene;
  }
};

CaseOutcome rocks(const CaseOptions& options, Progress& progress) {
  RockingColumn column;
  column.tilt = 0.5 * column.slope();
  const double quarter = column.quarter_period();
  const auto snapshots = record(column.scene(quarter / 1000, 2.5 * quarter), options, progress);
  // Rotation is measured from the start: upright is where it comes to the tilt. What is left of the energy is taken
  // half as far beyond. Later the elastic column hops on its edge, and what rounding leaves grows tenfold each 200
  // steps.
  const auto rotation = [&](std::size_t i) { return snapshots[i].blocks[1].rotation; };
  double upright = NAN, kept = NAN;
  for (std::size_t i = 1; i + 1 < snapshots.size() && std::isnan(kept); ++i) {
    const double before = rotation(i - 1), after = rotation(i), step = snapshots[i].time - snapshots[i - 1].time;
    if (std::isnan(upright) && after >= column.tilt)
      upright = snapshots[i - 1].time + (column.tilt - before) / (after - before) * step;
    if (after >= 1.5 * column.tilt) kept = column.energy(after - column.tilt, (rotation(i + 1) - before) / (2 * step));
  }
  CaseOutcome outcome;
  outcome.findings.push_back(
      {.quantity = "quarter period", .unit = "s", .expected = quarter, .computed = upright, .tolerance = 0.01});
  outcome.findings.push_back({.quantity = "energy kept in the first impact",
                              .unit = "",
                              .expected = column.energy_kept(),
                              .computed = kept,
                              .tolerance = 0.01});
  return outcome;
}

}  // namespace

std::vector<KnownCase> rocking_cases() {
  return {{.name = "rocking_column",
           .title = "A column of height/width 4 rocks on its edges",
           .source = "Housner 1963",
           .of_any_body = true,
           .run = rocks}};
}

}  // namespace talus
