#include "solve/dynamics/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

StepControl::StepControl(const AdaptiveSteps& settings, double half_height, double mesh_size,
                         const StepControlTolerances& tolerances)
    : settings_(settings),
      tolerances_(tolerances),
      displacement_limit_(settings.displacement_limit * half_height),
      error_limit_(settings.error_limit * mesh_size) {}

void StepControl::begin_stage(double longest) {
  longest_ = longest;
  length_ = length_ > 0 ? std::min(length_, longest) : longest;
}

double StepControl::factor(const StepMeasure& measure) const {
  double factor = tolerances_.growth;
  if (measure.displacement > 0)
    factor = std::min(factor, tolerances_.target * displacement_limit_ / measure.displacement);
  if (measure.time_error > 0)
    factor = std::min(factor, tolerances_.target * std::sqrt(error_limit_ / measure.time_error));
  if (measure.iterations > settings_.iterations) factor = std::min(factor, tolerances_.after_many_iterations);
  return std::max(factor, tolerances_.shrinkage);
}

bool StepControl::acceptable(const StepMeasure& measure, double length) const {
  if (!may_be_shorter(length)) return true;
  return measure.displacement <= tolerances_.refused_above * displacement_limit_ &&
         measure.time_error <= tolerances_.refused_above * error_limit_;
}

void StepControl::accept(const StepMeasure& measure, double length) {
  length_ = std::clamp(factor(measure) * length, settings_.shortest * longest_, longest_);
}

void StepControl::refuse(const StepMeasure& measure, double length) {
  const double shorter = std::min(factor(measure), tolerances_.after_refusal) * length;
  length_ = may_be_shorter(length) ? std::max(shorter, settings_.shortest * longest_) : shorter;
}

}  // namespace talus
