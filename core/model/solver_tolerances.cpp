#include "model/solver_tolerances.hpp"

#include <algorithm>
#include <cmath>

#include "model/solver_settings.hpp"

namespace talus {

namespace {

// However roughly steps are solved: what hardly moves yet is not to be stopped.
constexpr double fastest_sleeper = 1e-5;      // mesh sizes a second
constexpr double largest_load_change = 1e-2;  // of all that a sleeper bears

}  // namespace

SolverTolerances SolverTolerances::at(double tolerance) const {
  const double factor = tolerance / reference_tolerance.value;
  SolverTolerances other = *this;
  for (double* residual : {&other.convergence.dynamic_residual, &other.convergence.static_residual})
    *residual *= std::min(1.0, factor);
  other.sleep.speed = std::min(fastest_sleeper, sleep.speed * std::max(1.0, factor / 10));
  other.sleep.load_change = std::min(largest_load_change, sleep.load_change * std::max(1.0, factor));
  other.step.penetration = std::max(step.penetration, tolerance);
  for (double* of_impulses : {&other.impact.negligible_speed, &other.impact.impulse_accuracy}) *of_impulses *= factor;
  other.impact.sweep_limit = static_cast<int>(std::lround(impact.sweep_limit / std::pow(factor, 1.0 / 6)));
  return other;
}

}  // namespace talus
