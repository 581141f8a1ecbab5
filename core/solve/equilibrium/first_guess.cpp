#include "solve/equilibrium/first_guess.hpp"

#include <utility>

#include "bodies/rigid_motion.hpp"

namespace talus {

void FirstGuess::forget(int unknowns) {
  last_.setZero(unknowns);
  earlier_.setZero(unknowns);
  last_length_ = earlier_length_ = 0;
}

void FirstGuess::remember(const Increment& taken, double length) {
  std::swap(earlier_, last_);
  earlier_length_ = last_length_;
  last_ = taken;
  last_length_ = length;
}

void FirstGuess::choose(OpenClose& open_close, const BodySet& bodies, const StepContext& step, Increment& d) {
  d.setZero();
  double best = open_close.residual_at(d);
  const bool may_be_rounding = best <= open_close.residual().rounding_of_positions();
  const double better = may_be_rounding ? tolerances_.clearly_better : tolerances_.better;
  if (step.dynamic_factor == 0) best *= tolerances_.creeping;
  const auto offer = [&](const Increment& guess) {
    const double residual = open_close.residual_at(guess);
    if (!(residual < better * best)) return;
    best = residual;
    d = guess;
  };
  if (last_length_ > 0) {
    guess_ = step.length / last_length_ * last_;
    offer(guess_);
  }
  if (step.dynamic_factor == 0) return;
  if (earlier_length_ > 0) {
    guess_ = step.length * (2 / last_length_ * last_ - 1 / earlier_length_ * earlier_);
    offer(guess_);
  }
  continue_motion(bodies, step.length, guess_);
  offer(guess_);
}

}  // namespace talus
