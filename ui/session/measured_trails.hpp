#pragma once

#include <memory>

#include "measures/block_trails.hpp"
#include "session/results_measure.hpp"

namespace talus {

class Display;

/// The ways of the blocks' centres through the results that are open, while trails are to be shown.
class MeasuredTrails : public ResultsMeasure {
  Q_OBJECT
 public:
  MeasuredTrails(Playback& playback, Display& display);

  /// Null where they are not measured yet, or not wanted.
  const std::shared_ptr<const BlockTrails>& trails() const { return trails_; }

 private:
  Work work() override;
  void forget() override { trails_.reset(); }

  std::shared_ptr<const BlockTrails> trails_;
};

}  // namespace talus
