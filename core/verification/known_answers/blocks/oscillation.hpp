#pragma once

#include <functional>
#include <vector>

#include "verification/known_answers/support/known_case.hpp"

namespace talus {

/// A rigid mass on dry friction, driven by an acceleration: it starts forwards when the drive exceeds `forward`,
/// backwards when it falls below −`backward`, and slows down by as much while it moves.
struct DrivenMass {
  std::function<double(double)> drive;  ///< m/s², of time
  double forward = 0, backward = 0;     ///< m/s²

  /// Where it is at each whole step after starting at rest [m]; the velocity is stopped at zero within a step.
  std::vector<double> path(double duration, double time_step) const;
};

/// Potra's block under an oscillating force; a flat base and an incline that shake (Newmark's sliding block).
std::vector<KnownCase> oscillation_cases();

}  // namespace talus
