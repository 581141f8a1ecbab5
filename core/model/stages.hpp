#pragma once

#include "model/project.hpp"

namespace talus {

/// A static stage of `steps` steps [s each], in which blocks are pressed onto each other by their loads.
inline Stage static_stage(double time_step, int steps) {
  Stage stage;
  stage.name = "static";
  stage.kind = StageKind::static_;
  stage.time_step = time_step;
  stage.steps = steps;
  return stage;
}

/// A dynamic stage [s].
inline Stage dynamic_stage(double time_step, double duration) {
  Stage stage;
  stage.name = "dynamic";
  stage.time_step = time_step;
  stage.duration = duration;
  return stage;
}

}  // namespace talus
