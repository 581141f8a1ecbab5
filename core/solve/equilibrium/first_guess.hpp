#pragma once

#include <vector>

#include "solve/equilibrium/open_close.hpp"

namespace talus {

/// Where the iteration of a step begins: each independent system at that one of a few guesses which leaves it the
/// smallest residual. The guesses are no motion; the increment of the last step; that of the last two extrapolated; and
/// what velocity and spin give. The paper's integrator turns the velocity of a sticking node round each step, so that
/// velocity alone is no good guess.
class FirstGuess {
 public:
  explicit FirstGuess(const FirstGuessTolerances& tolerances = {}) : tolerances_(tolerances) {}

  /// A stage begins, or bodies fell asleep or woke: forgets the last steps.
  void forget(int unknowns);
  /// The increment of a step of `length` [s] was accepted.
  void remember(const Increment& taken, double length);
  /// Between OpenClose::begin_step and converge.
  void choose(OpenClose& open_close, const BodySet& bodies, const StepContext& step, Increment& d);

  /// What it remembers from step to step.
  void archive(auto& state) { state(last_, earlier_, last_length_, earlier_length_); }

 private:
  /// Systems that a guess leaves a clearly smaller residual begin there.
  void offer(const Increment& guess, OpenClose& open_close, double better, Increment& d);

  FirstGuessTolerances tolerances_;
  Increment last_, earlier_, guess_;
  std::vector<double> least_;                    // N, of each system: the residual where it begins
  std::vector<char> is_better_;                  // a system
  double last_length_ = 0, earlier_length_ = 0;  ///< s; 0: there is none
};

}  // namespace talus
