#pragma once

#include "model/solver_tolerances.hpp"

namespace talus {

/// Watches whether the residual still falls.
class ResidualProgress {
 public:
  explicit ResidualProgress(const ConvergenceTolerances& tolerances) : tolerances_(tolerances) {}

  /// Takes the residual of the next iteration [N].
  void note(double residual) {
    iterations_ = residual > tolerances_.stalled_fraction * lowest_ ? iterations_ + 1 : 0;
    if (iterations_ == 0) lowest_ = residual;
    is_low_ = tolerances_.stalled_fraction * residual <= lowest_;
  }
  /// It is as low as it was before, or does not get there again.
  bool has_stalled() const {
    return iterations_ >= (is_low_ ? tolerances_.stalled_iterations : tolerances_.newton_iterations);
  }
  bool goes_in_circles() const { return iterations_ >= tolerances_.newton_iterations; }
  void begin_anew() { lowest_ = 1e300; }

 private:
  const ConvergenceTolerances& tolerances_;
  double lowest_ = 1e300;  // N, when it fell last
  int iterations_ = 0;     // since then
  bool is_low_ = true;     // now
};

}  // namespace talus
