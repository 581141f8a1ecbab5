#pragma once

#include "model/project.hpp"

namespace talus {

/// s of model time, where the stage does not end sooner: its duration, or steps times step.
inline double length_of(const Stage& stage) {
  return stage.steps ? *stage.steps * stage.time_step : stage.duration.value_or(0);
}

}  // namespace talus
