#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "results/frame.hpp"
#include "results/run_report.hpp"

namespace talus {

struct BlockSystem;
struct Project;

struct BodySet;

/// How a run talks to the one who started it. All functions are called from the solving thread, all but on_iteration
/// after a step.
class RunObserver {
 public:
  virtual ~RunObserver() = default;
  /// After every accepted step. `fraction` of the model time that is done, 0…1.
  virtual void on_step(const StepReport& step, const HistoryRow& history, double fraction) = 0;
  /// The same step, before `on_step`: the bodies at its end.
  virtual void on_bodies(const StepReport&, const BodySet&) {}
  /// With each open–close iteration of the step that is being made, and the force out of balance then [N].
  virtual void on_iteration(double /*unbalanced*/) {}
  /// After every frame that was written.
  virtual void on_frame(std::shared_ptr<const Frame> frame) = 0;
  /// Asked after steps of which no frame is written: whether someone looks on who has waited for one.
  virtual bool wants_moment() { return false; }
  /// Where blocks are then: a frame that is not written, with the number, the stresses and the classes of motion of the
  /// last one that was.
  virtual void on_moment(std::shared_ptr<const Frame>) {}
  /// With every frame: what each effect has cost so far.
  virtual void on_effects(const std::vector<EffectOutcome>&) {}
  /// After every step that was hard somewhere: the hardest places of the run so far, the hardest first.
  virtual void on_troubles(const std::vector<ConvergenceTrouble>&) {}
  /// Asked between steps; may block (a pause). False ends the run cleanly as `stopped`.
  virtual bool go_on() = 0;
};

struct RunOptions {
  std::filesystem::path out;  ///< results folder
  std::string project_text;   ///< kept beside the results
  int threads = 1;            ///< at most; their number changes no bit of the results
  /// Goes on from the checkpoint in the folder, to the same bits as a run that was not disturbed; the project is that
  /// of the run, or one that change_since_run() allows. Begins at the start where there is none.
  bool resume = false;
  double checkpoint_every = 60;  ///< s of wall time; before the last step of a stage there is one too
};

/// Runs all stages of the project on its blocks and writes the results folder.
/// Non-convergence is a status of the report, not an exception.
RunReport run(const Project& project, const BlockSystem& system, const RunOptions& options, RunObserver& observer);

}  // namespace talus
