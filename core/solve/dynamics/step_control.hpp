#pragma once

#include "model/solver_settings.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// What a trial step came to, in the terms of the limits of adaptive steps.
struct StepMeasure {
  double displacement = 0;  ///< m, largest of a node
  double time_error = 0;    ///< m, estimated, of time integration
  int iterations = 0;
};

/// Chooses the length of the next step so that displacement, estimated error and number of iterations keep their
/// limits. Steps grow by no more than half and shrink by no more than to a fifth at a time.
class StepControl {
 public:
  /// `half_height`, `mesh_size` [m]: what the limits are relative to.
  StepControl(const AdaptiveSteps& settings, double half_height, double mesh_size,
              const StepControlTolerances& tolerances = {});

  /// A stage begins whose longest step is `longest` [s].
  void begin_stage(double longest);
  double length() const { return length_; }  ///< s, to try next
  /// A step that breaks a limit by more than half is not worth keeping unless it is the shortest allowed.
  bool acceptable(const StepMeasure& measure, double length) const;
  bool may_be_shorter(double length) const { return length > settings_.shortest * longest_; }
  /// A step of this length [s] was accepted.
  void accept(const StepMeasure& measure, double length);
  /// A step of this length [s] was refused: the next is shorter, even if it was the shortest allowed.
  void refuse(const StepMeasure& measure, double length);

  /// What it remembers from step to step.
  void archive(auto& state) { state(longest_, length_); }

 private:
  double factor(const StepMeasure& measure) const;

  AdaptiveSteps settings_;
  StepControlTolerances tolerances_;
  double displacement_limit_, error_limit_;
  double longest_ = 0, length_ = 0;
};

}  // namespace talus
