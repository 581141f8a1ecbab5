#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "model/project.hpp"

namespace talus {

struct BlockSystem;

/// What a step of the run's own length took.
struct TimedStep {
  double length = 0;          ///< s of model time
  double seconds = 0;         ///< of the processor, with what was written
  double detecting = 0;       ///< share of that, 0 to 1, for the search for contacts …
  double iterating = 0;       ///< … and for what each iteration does again
  int iterations = 0;         ///< of the step
  double out_of_balance = 0;  ///< as StepReport's
};

struct StageBeginning {
  std::vector<TimedStep> steps;  ///< the first ones of the stage
  bool ended = false;            ///< they are all of them
};

/// How a run begins: as much of it as a budget allows, solved and written as the run itself would be.
struct RunBeginning {
  std::vector<StageBeginning> stages;  ///< those that were reached
  double around = 0;                   ///< s of the processor, before the first step and after the last
  double memory = 0;                   ///< bytes that were held at most, beside the blocks
  double seconds = 0;                  ///< of the processor, that looking took
  bool whole = false;                  ///< it is the run: nothing was left out
  std::string failure;                 ///< of the run, why it does not converge; empty: as far as was seen it does
};

/// Of `left` steps that a stage has left, how many come until it ends. Where it ends at equilibrium, what is out of
/// balance is taken to go on falling as it did in the second half of the steps that were seen, by one factor a step.
double steps_to_end(const Stage& stage, const StageBeginning& seen, double left);

/// The project whose run is the beginning: static stages of many steps are gone through in `static_steps` of them and a
/// few long ones, so that what comes after them is seen as well.
Project beginning_of(const Project& project, int static_steps);

/// On one thread, into a folder that goes away again. `budget`: s of the processor; static stages get half of it at
/// most. Where it lasts for fewer than four steps, or for less than a tenth of the run, up to five times as much is
/// spent, unless that would last for less than a hundredth of it; two steps are taken whatever they cost. Throws
/// InputError as Simulation does, Cancelled.
RunBeginning run_beginning(const Project& project, const BlockSystem& system, double budget, Progress& progress);

}  // namespace talus
