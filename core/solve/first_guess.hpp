#pragma once

#include "solve/open_close.hpp"

namespace talus {

/// Where the iteration of a step begins: at that one of a few guesses which leaves the smallest residual. Standing
/// still; as the last step went on; as the last two went on; as velocity and spin lead. The paper's integrator turns
/// the velocity of a sticking node round each step, so that the velocity alone is no good guess.
class FirstGuess {
 public:
  /// A stage begins: nothing to go by.
  void forget(int unknowns);
  /// The increment of a step of `length` [s] was taken.
  void remember(const Increment& taken, double length);
  /// Between OpenClose::begin_step and settle.
  void choose(OpenClose& open_close, const BodySet& bodies, const StepContext& step, Increment& d);

 private:
  Increment last_, earlier_, guess_;
  double last_length_ = 0, earlier_length_ = 0;  ///< s; 0: there is none
};

}  // namespace talus
