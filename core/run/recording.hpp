#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/checkpoint.hpp"
#include "results/convergence_trouble.hpp"
#include "results/folder.hpp"
#include "results/result_folder.hpp"
#include "run/event_watch.hpp"
#include "run/expectation_watch.hpp"
#include "run/interpenetration_watch.hpp"
#include "run/motion_watch.hpp"
#include "run/run.hpp"
#include "solve/simulation.hpp"

namespace talus {

/// What a run leaves behind: frames, histories and steps as it goes, checkpoints now and then, the report at its end.
class Recording {
 public:
  /// All outlive it. The simulation is at its start.
  Recording(const Project& project, const BlockSystem& system, const RunOptions& options, Simulation& simulation,
            RunObserver& observer);

  /// Makes the results folder, with the first frame. Throws InputError as ResultWriter does.
  void begin();
  /// Goes on in the results folder from where a run was, and takes the simulation there. Throws InputError where the
  /// checkpoint is not of this program, or less is in the folder than it says.
  void resume(const Checkpoint& from);

  /// Lets the simulation take a step. From a run that has failed none can go on: then the last checkpoint stays.
  void take_step();
  /// Whether blocks were seen to lie in each other: the run is over.
  bool interpenetrating() const { return interpenetrating_.has_value(); }
  RunReport finish();
  /// Nothing more can be written: tells what is kept, and that the run can go on.
  RunReport break_off(const WriteError& error);

 private:
  void gather_report();
  void take(StepReport step);
  void note_troubles();
  void write_frame();
  void keep_checkpoint();
  /// What it remembers from step to step.
  void archive(StateArchive& state);

  const Project& project_;
  const BlockSystem& system_;
  const RunOptions& options_;
  Simulation& simulation_;
  RunObserver& observer_;
  EventWatch events_;
  MotionWatch motions_;
  std::vector<Event> stage_events_;
  TroubleList troubles_;
  ExpectationWatch expectations_;
  InterpenetrationWatch interpenetration_;
  std::optional<ConvergenceTrouble> interpenetrating_;
  std::optional<ResultWriter> writer_;
  double next_frame_;                        ///< s
  std::shared_ptr<const Frame> last_frame_;  ///< null before the first
  double next_checkpoint_ = 0;               ///< s, wall time of the run
  RunReport report_;
};

}  // namespace talus
