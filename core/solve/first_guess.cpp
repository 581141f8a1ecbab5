#include "solve/first_guess.hpp"

#include <utility>

#include "bodies/rigid_motion.hpp"

namespace talus {

namespace {

/// In a static stage a step goes on as the last one did only where that leaves less than this share of what standing
/// still does: where the bodies creep steadily. Anywhere else it may lead past the strength of contacts that would
/// hold, and a wedge between joints that dilate has a second balance there, sliding.
constexpr double creeping = 0.01;
/// A guess is better if it leaves less than this share: a residual that rounding made less keeps blocks awake.
constexpr double better = 1 - 1e-6;
/// Where what is left may be the rounding of positions, a guess is to leave less than this share: going on as before
/// would but stir the rounding, and blocks at rest would be solved for ever.
constexpr double clearly_better = 0.5;

}  // namespace

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
  const double share = best <= open_close.balance().rounding_of_positions() ? clearly_better : better;
  if (step.dynamic_factor == 0) best *= creeping;
  const auto offer = [&](const Increment& guess) {
    const double residual = open_close.residual_at(guess);
    if (!(residual < share * best)) return;
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
