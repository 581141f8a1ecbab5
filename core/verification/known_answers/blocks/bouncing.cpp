#include <algorithm>
#include <cmath>

#include "model/stages.hpp"
#include "verification/known_answers/blocks/block_cases.hpp"
#include "verification/known_answers/support/recorded_run.hpp"

namespace talus {

namespace {

constexpr double gravity = 9.81, height = 1, restitution = 0.6;  ///< m/s², m

/// A block that falls on its face. It is rigid: an elastic one takes up speed in waves that the law of impact does not
/// see.
CaseScene falling_block() {
  CaseScene scene = rock_scene(30);
  scene.project.joints[0].restitution = restitution;
  scene.add_fixed_box("floor", Vec3(-2, -2, -1), Vec3(3, 3, 0));
  scene.add_block("block", box_mesh(Vec3(0, 0, height), Vec3(1, 1, 1 + height), 1, 1, 1), BodyKind::rigid);
  const double fall = std::sqrt(2 * height / gravity);
  scene.project.stages = {dynamic_stage(fall / 1000, fall * (1 + 2 * restitution * (1 + restitution + 0.5)))};
  return scene;
}

CaseOutcome bounces(const CaseOptions& options, Progress& progress) {
  std::vector<double> peaks, times;  // m and s of the bounces so far
  double speed = 0;
  for (const Snapshot& snapshot : record(falling_block(), options, progress)) {
    const BlockMotion& block = snapshot.blocks[1];
    const double now = block.velocity.z(), high = height + block.displacement.z();
    if (speed < 0 && now > 0) {
      times.push_back(snapshot.time);
      peaks.push_back(0);
    }
    if (!peaks.empty()) peaks.back() = std::max(peaks.back(), high);
    speed = now;
  }
  peaks.resize(2);
  times.resize(2);
  CaseOutcome outcome;
  const double fall = std::sqrt(2 * height / gravity);
  const auto hold = [&](const char* quantity, const char* unit, double expected, double computed) {
    outcome.findings.push_back(
        {.quantity = quantity, .unit = unit, .expected = expected, .computed = computed, .tolerance = 0.005});
  };
  hold("height of the first bounce", "m", height * std::pow(restitution, 2), peaks[0]);
  hold("height of the second bounce", "m", height * std::pow(restitution, 4), peaks[1]);
  hold("time between the first two impacts", "s", 2 * restitution * fall, times[1] - times[0]);
  return outcome;
}

}  // namespace

std::vector<KnownCase> bouncing_cases() {
  return {{.name = "bouncing_block",
           .title = "A rigid block bounces with a restitution of 0.6",
           .source = "Newton: h e², h e⁴, 2 e √(2h/g)",
           .run = bounces}};
}

}  // namespace talus
