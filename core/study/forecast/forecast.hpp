#pragma once

#include <optional>
#include <string>

#include "base/progress.hpp"
#include "model/project.hpp"

namespace talus {

struct BlockSystem;

/// What a run will cost with the settings as they are, from a few of its steps on this machine.
struct Forecast {
  double seconds = 0;           ///< of the processor, on one thread: solving and writing
  double fewest = 0, most = 0;  ///< s between which `seconds` is thought to come out
  double memory = 0;            ///< bytes that solving holds at most, beside the blocks
  long steps = 0;               ///< of the whole run, where no static stage ends sooner
  double share_seen = 0;        ///< of `seconds`, that was measured and not foreseen; 1: the run itself was made
  std::optional<double> error;  ///< of the displacements by step doubling, over the largest; empty: not known
  std::string failure;          ///< why the run will not converge; `seconds` are those until then; empty: not known to
  double forecast_seconds = 0;  ///< of the processor, that the forecast took
};

/// Spends `budget` [s of the processor], of a long run up to three and a half times as much, and the last step of each
/// of its parts: on the beginning of the run, solved and written as it will be (RunBeginning), and on the whole of it
/// in outline (RunOutline). What remains of a stage is taken to cost what the last steps that were seen did: their
/// search for contacts in proportion to the contacts in the outline, everything else to the unknowns awake there; where
/// only first steps were seen, with no more iterations than there. What the steps leave out is said by the run in steps
/// half as long where it is short enough to be made twice more (error_by_step_doubling), else by the outline in steps
/// half as long (first order in the step, Richardson 1911). Throws InputError as Simulation does, Cancelled.
Forecast forecast(const Project& project, const BlockSystem& system, double budget, Progress& progress);

}  // namespace talus
