#pragma once

#include <optional>

#include "base/progress.hpp"
#include "mesh/block.hpp"
#include "model/project.hpp"

namespace talus {

/// What a run will cost with the settings as they are, from a pilot run on this machine.
struct Forecast {
  double seconds = 0;           ///< wall time of solving, on the threads that the caller has; writing comes on top
  double memory = 0;            ///< bytes that solving holds beside the blocks
  long steps = 0;               ///< of the whole run, where no static stage ends sooner
  double share_seen = 0;        ///< of the run's model time, that the pilot came through; the rest is like its end
  std::optional<double> error;  ///< of the displacements by step doubling, over the largest; empty: not known
  double pilot_seconds = 0;     ///< wall time that the forecast took
};

/// The pilot: stages of many steps are gone through in leaps, twenty times as long as a step at most, with a few steps
/// of the true length between them, which are timed. Shorter ones are gone through as they are.
Project pilot_of(const Project& project);

/// Runs the pilot, for `budget` [s] at most; where that leaves time, a second one with leaps half as long, from which
/// follows what the steps leave out (first order in the step, Richardson 1911). Throws InputError as Simulation does,
/// Cancelled.
Forecast forecast(const Project& project, const BlockSystem& system, double budget, Progress& progress);

}  // namespace talus
