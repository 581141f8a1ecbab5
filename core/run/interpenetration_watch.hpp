#pragma once

#include <optional>

#include "contact/passage/bodies_in_each_other.hpp"
#include "results/run_report.hpp"

namespace talus {

class Simulation;

/// Watches that no blocks come to lie in each other: what contacts do not hold apart the run must not tell as motion.
class InterpenetrationWatch {
 public:
  /// At the start of the run. Both outlive the watch.
  InterpenetrationWatch(const BlockSystem& system, const Simulation& simulation);

  /// After a step. The blocks that are deepest in each other, if by more than a hundredth of their mesh size and than
  /// twice the deepest that contacts knew, in this step or before (`known`, of the mesh size).
  std::optional<ConvergenceTrouble> look(const StepReport& step, double known);

 private:
  const BlockSystem& system_;
  const Simulation& simulation_;
  BodiesInEachOther shapes_;
};

}  // namespace talus
