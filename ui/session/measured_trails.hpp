#pragma once

#include <memory>

#include "measures/block_trails.hpp"
#include "session/results_measure.hpp"

namespace talus {

class CurrentProject;
class Display;

/// The ways of the blocks' centres through the results that are open, or through a run that goes on as far as it has
/// come, while trails are to be shown.
class MeasuredTrails : public ResultsMeasure {
  Q_OBJECT
 public:
  MeasuredTrails(CurrentProject& project, Playback& playback, Display& display);

  /// Null where they are not measured yet, or not wanted.
  const std::shared_ptr<const BlockTrails>& trails() const { return trails_; }

 private:
  Work work() override;
  void forget() override;
  void followRun();

  CurrentProject& project_;
  Playback& playback_;
  Display& display_;
  std::unique_ptr<TrailTracer> live_;  ///< of the run that goes on, or has just ended
  std::shared_ptr<const BlockTrails> trails_;
};

}  // namespace talus
