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

void FirstGuess::offer(const Increment& guess, OpenClose& open_close, double better, Increment& d) {
  open_close.residual_at(guess);
  const StepResidual& residual = open_close.residual();
  is_better_.resize(residual.systems());
  for (int s = 0; s < residual.systems(); ++s) {
    is_better_[s] = residual.norm_of_system(s) < better * least_[s];
    if (is_better_[s]) least_[s] = residual.norm_of_system(s);
  }
  for (Eigen::Index block = 0; 3 * block < d.size(); ++block)
    if (is_better_[residual.system_of(static_cast<int>(block))]) d.segment<3>(3 * block) = guess.segment<3>(3 * block);
}

void FirstGuess::choose(OpenClose& open_close, const BodySet& bodies, const StepContext& step, Increment& d) {
  d.setZero();
  const StepResidual& residual = open_close.residual();
  const bool may_be_rounding = open_close.residual_at(d) <= residual.rounding_of_positions();
  const double better = may_be_rounding ? tolerances_.clearly_better : tolerances_.better;
  least_.resize(residual.systems());
  for (int s = 0; s < residual.systems(); ++s)
    least_[s] = residual.norm_of_system(s) * (step.dynamic_factor == 0 ? tolerances_.creeping : 1);
  if (last_length_ > 0) {
    guess_ = step.length / last_length_ * last_;
    offer(guess_, open_close, better, d);
  }
  if (step.dynamic_factor == 0) return;
  if (earlier_length_ > 0) {
    guess_ = step.length * (2 / last_length_ * last_ - 1 / earlier_length_ * earlier_);
    offer(guess_, open_close, better, d);
  }
  continue_motion(bodies, step.length, guess_);
  offer(guess_, open_close, better, d);
}

}  // namespace talus
