#include "solve/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

constexpr double aim = 0.8;        ///< of a limit, so that the next step seldom breaks it
constexpr double grow = 1.5;       ///< at most, from step to step
constexpr double shrink = 0.2;     ///< at most
constexpr double tolerated = 1.5;  ///< times a limit
constexpr double too_many = 0.7;   ///< where iterations exceed their limit

}  // namespace

StepControl::StepControl(const AdaptiveSteps& settings, double half_height, double mesh_size)
    : settings_(settings),
      displacement_limit_(settings.displacement_limit * half_height),
      error_limit_(settings.error_limit * mesh_size) {}

void StepControl::begin_stage(double longest) {
  longest_ = longest;
  length_ = length_ > 0 ? std::min(length_, longest) : longest;
}

double StepControl::factor(const StepMeasure& measure) const {
  double factor = grow;
  if (measure.displacement > 0) factor = std::min(factor, aim * displacement_limit_ / measure.displacement);
  if (measure.time_error > 0) factor = std::min(factor, aim * std::sqrt(error_limit_ / measure.time_error));
  if (measure.iterations > settings_.iterations) factor = std::min(factor, too_many);
  return std::max(factor, shrink);
}

bool StepControl::acceptable(const StepMeasure& measure, double length) const {
  if (!may_be_shorter(length)) return true;
  return measure.displacement <= tolerated * displacement_limit_ && measure.time_error <= tolerated * error_limit_;
}

void StepControl::taken(const StepMeasure& measure, double length) {
  length_ = std::clamp(factor(measure) * length, settings_.shortest * longest_, longest_);
}

void StepControl::refused(const StepMeasure& measure, double length) {
  length_ = std::max(std::min(factor(measure), 0.5) * length, settings_.shortest * longest_);
}

}  // namespace talus
