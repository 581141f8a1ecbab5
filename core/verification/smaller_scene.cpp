#include "verification/smaller_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace talus {

namespace {

/// Those that have nothing to do with where blocks are to be at the end, in the order in which they are looked for.
constexpr std::array laws{FaultKind::not_converged,    FaultKind::not_finite, FaultKind::inverted,
                          FaultKind::interpenetration, FaultKind::energy,     FaultKind::penetration};

bool has(const Trial& trial, FaultKind kind) {
  const std::vector<Fault> list = faults_by_kind(trial);
  return std::any_of(list.begin(), list.end(), [kind](const Fault& fault) { return fault.kind == kind; });
}

class Shrinking {
 public:
  Shrinking(CaseScene scene, FaultKind kind, int runs, const TrialOptions& options, Progress& progress)
      : scene_(std::move(scene)), kind_(kind), runs_(runs), options_(options), progress_(progress) {}

  CaseScene smallest() {
    while (scene_.project.stages.size() > 1 && takes(without_last_stage())) continue;
    while (steps_of_last_stage() > 1 && takes(with_half_of_last_stage())) continue;
    if (scene_.project.solids.empty()) leave_blocks_out();
    return scene_;
  }

 private:
  /// Whether the candidate is the scene from now on.
  bool takes(CaseScene candidate) {
    if (runs_-- <= 0) return false;
    HardCase one;
    one.build = [&candidate] { return candidate; };
    if (!has(run_trial(one, options_, progress_), kind_)) return false;
    scene_ = std::move(candidate);
    return true;
  }

  CaseScene without_last_stage() const {
    CaseScene candidate = scene_;
    candidate.project.stages.pop_back();
    return candidate;
  }

  double steps_of_last_stage() const {
    const Stage& stage = scene_.project.stages.back();
    return stage.steps ? *stage.steps : std::ceil(*stage.duration / stage.time_step);
  }

  CaseScene with_half_of_last_stage() const {
    CaseScene candidate = scene_;
    Stage& stage = candidate.project.stages.back();
    const double half = std::ceil(steps_of_last_stage() / 2);
    if (stage.steps)
      stage.steps = static_cast<int>(half);
    else
      stage.duration = half * stage.time_step;
    return candidate;
  }

  void leave_blocks_out() {
    for (std::size_t b = scene_.system.blocks.size(); b-- > 0 && scene_.system.blocks.size() > 1;) {
      CaseScene candidate = scene_;
      const std::string name = candidate.system.blocks[b].name;
      candidate.system.blocks.erase(candidate.system.blocks.begin() + static_cast<std::ptrdiff_t>(b));
      std::erase_if(candidate.project.velocities, [&](const InitialVelocity& one) { return one.block == name; });
      std::erase_if(candidate.project.constraints, [&](const Constraint& one) { return one.block == name; });
      takes(std::move(candidate));
    }
  }

  CaseScene scene_;
  FaultKind kind_;
  int runs_;
  const TrialOptions& options_;
  Progress& progress_;
};

}  // namespace

std::optional<FaultKind> law_broken(const Trial& trial) {
  for (const FaultKind kind : laws)
    if (has(trial, kind)) return kind;
  return std::nullopt;
}

CaseScene smaller_scene(const CaseScene& scene, FaultKind kind, int most_runs, const TrialOptions& options,
                        Progress& progress) {
  return Shrinking(scene, kind, most_runs, options, progress).smallest();
}

}  // namespace talus
