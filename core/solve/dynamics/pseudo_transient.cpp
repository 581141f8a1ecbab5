#include "solve/dynamics/pseudo_transient.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

double PseudoTransientContinuation::power_of_two(double fraction) const {
  return std::clamp(std::exp2(std::ceil(std::log2(fraction))), tolerances_.least_inertia, 1.0);
}

bool PseudoTransientContinuation::needs_retry(bool converged, double displacement) const {
  return fraction_ < 1 && (!converged || displacement > tolerances_.largest_displacement * longest_displacement_);
}

double PseudoTransientContinuation::fraction_for(double displacement) const {
  return fraction_ * displacement / (tolerances_.largest_displacement * longest_displacement_);
}

void PseudoTransientContinuation::restore_inertia(bool converged, double displacement) {
  if (!converged) wanted_ = 1;
  fraction_ = converged ? power_of_two(fraction_for(displacement)) : 1;
}

void PseudoTransientContinuation::accept(double displacement, double static_residual) {
  if (fraction_ == 1) longest_displacement_ = std::max(longest_displacement_, displacement);
  if (static_residual > tolerances_.at_rest) {
    const bool falls = static_residual < (1 - tolerances_.steady_residual) * last_static_residual_;
    wanted_ *= falls ? std::pow(static_residual / last_static_residual_, tolerances_.power) : tolerances_.growth;
    wanted_ = std::clamp(wanted_, tolerances_.least_inertia, 1.0);
    fraction_ = power_of_two(std::max(wanted_, fraction_for(displacement)));
  }
  last_static_residual_ = static_residual;
}

}  // namespace talus
