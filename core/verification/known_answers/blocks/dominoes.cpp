#include "verification/known_answers/blocks/dominoes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/known_answers/support/recorded_run.hpp"

namespace talus {

namespace {

/// The leaning row as one mechanism, driven by the tilt of its foremost domino.
struct LeaningRow {
  double height_sum = 0;   ///< Σ height of the centroids
  double inertia_sum = 0;  ///< Σ (dθᵢ/dθ)², in units of a domino's moment of inertia about its edge
};

LeaningRow leaning_row(const DominoRow& row, int count, double tilt) {
  LeaningRow sums;
  double rate = 1;
  for (int i = 0; i < count; ++i) {
    sums.height_sum += (std::cos(tilt) + row.thickness * std::sin(tilt)) / 2;
    sums.inertia_sum += rate * rate;
    // A domino's upper edge lies on the back of the next: sin(θ' − θ) = (s + d) cos θ − d.
    const double sine = row.pitch() * std::cos(tilt) - row.thickness;
    const double more = std::asin(std::min(1.0, sine));
    rate *= 1 - row.pitch() * std::sin(tilt) / std::cos(more);
    tilt += more;
  }
  return sums;
}

constexpr double push = 1;  // √(g/h)

CaseScene domino_scene(const DominoRow& row, int count) {
  CaseScene scene = rock_scene(0);
  const double g = scene.project.gravity.norm();
  Joint rough;
  rough.name = "rough";
  rough.friction_angle = 80;
  scene.add_joint(rough);
  scene.add_fixed_box("floor", Vec3(-1, -1, -0.5), Vec3(count * row.pitch() + 2, 1, 0));
  for (int i = 0; i < count; ++i) {
    const std::string name = "domino " + std::to_string(i + 1);
    const double x = i * row.pitch();
    scene.add_box(name, Vec3(x, -0.2, 0), Vec3(x + row.thickness, 0.2, 1));
    scene.project.interfaces.push_back({{"floor", name}, "rough"});
  }
  // Turning about its lower front edge.
  InitialVelocity first;
  first.block = "domino 1";
  const double speed = push * std::sqrt(g);
  first.angular = Vec3(0, speed, 0);
  first.linear = first.angular.cross(Vec3(-row.thickness / 2, 0, 0.5));
  scene.project.velocities = {first};
  scene.project.stages = {dynamic_stage(0.0005, 1)};
  return scene;
}

/// Times [s] at which dominoes come to the tilt of a strike, in their order; the run ends after the last but one, or
/// when twice the time has passed that they should have taken.
std::vector<double> strikes(const DominoRow& row, int count, const CaseOptions& options, Progress& progress) {
  CaseScene scene = domino_scene(row, count);
  double expected = 0;
  for (const double speed : row.front_speeds(push, count - 1)) expected += row.pitch() / speed;
  scene.project.stages[0].duration = 2 * expected / std::sqrt(scene.project.gravity.norm());
  std::vector<double> times;
  double before = 0, tilt_before = 0;
  record(scene, options, progress, [&](const Snapshot& snapshot) {
    const double tilt = snapshot.blocks[times.size() + 1].rotation;
    if (tilt >= row.strike()) {
      times.push_back(before + (row.strike() - tilt_before) / (tilt - tilt_before) * (snapshot.time - before));
      tilt_before = snapshot.blocks[times.size() + 1].rotation;
    } else {
      tilt_before = tilt;
    }
    before = snapshot.time;
    return static_cast<int>(times.size()) < count - 1;
  });
  return times;
}

CaseOutcome fall(const CaseOptions& options, Progress& progress) {
  CaseOutcome outcome;
  const int count = options.thorough ? 16 : 9;
  for (const double spacing : {0.3, 0.5}) {
    const DominoRow row{0.15, spacing};
    const std::string name = ", spacing " + decimals(spacing, 1);
    const auto times = strikes(row, count, options, progress);
    const auto expected = row.front_speeds(push, count - 1);
    outcome.findings.push_back({.quantity = "dominoes that came to strike the next" + name,
                                .unit = "",
                                .expected = count - 1.0,
                                .computed = static_cast<double>(times.size()),
                                .tolerance = 0});
    CaseTable table{"Front in √(gh)" + name, {"from domino", "expected", "computed"}, {}};
    double speed = NAN;
    for (std::size_t i = 1; i < times.size(); ++i) {
      speed = row.pitch() / (times[i] - times[i - 1]) / std::sqrt(9.81);
      table.rows.push_back({std::to_string(i + 1), decimals(expected[i], 3), decimals(speed, 3)});
    }
    outcome.findings.push_back({.quantity = "last speed of the front/√(gh)" + name,
                                .unit = "",
                                .expected = expected.back(),
                                .computed = speed,
                                .tolerance = 0.05,
                                .reported = true});
    outcome.tables.push_back(table);
  }
  outcome.remarks.push_back(
      "Dominoes are elastic here and rebound a little: single pitches are faster or slower than those of a row that "
      "keeps together, so their speed is shown and not held to.");
  return outcome;
}

}  // namespace

double DominoRow::strike() const { return std::asin(spacing); }

std::vector<double> DominoRow::front_speeds(double start, int count) const {
  const double inertia = (1 + thickness * thickness) / 3;  // of a domino of unit mass
  const int parts = 2000;
  std::vector<double> speeds;
  double rate = start;
  for (int fallen = 1; fallen <= count; ++fallen) {
    const LeaningRow upright = leaning_row(*this, fallen, 0);
    const double energy = inertia / 2 * upright.inertia_sum * rate * rate + upright.height_sum;
    const auto rate_at = [&](const LeaningRow& sums) {
      return std::sqrt(2 * (energy - sums.height_sum) / (inertia * sums.inertia_sum));
    };
    double time = 0;
    for (int k = 0; k < parts; ++k)
      time += strike() / parts / rate_at(leaning_row(*this, fallen, (k + 0.5) * strike() / parts));
    speeds.push_back(pitch() / time);
    const LeaningRow striking = leaning_row(*this, fallen, strike());
    rate = rate_at(striking) * striking.inertia_sum / (striking.inertia_sum + 1);
  }
  return speeds;
}

std::vector<KnownCase> domino_cases() {
  return {{.name = "dominoes",
           .title = "Dominoes without friction and without rebound",
           .source = "van Leeuwen 2010; a row that leans on itself, integrated",
           .takes_long = true,
           .thinned = true,
           .of_any_body = true,
           .run = fall}};
}

}  // namespace talus
