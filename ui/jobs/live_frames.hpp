#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "results/frame.hpp"

namespace talus {

/// Bytes that a frame holds in memory.
std::size_t frame_bytes(const Frame& frame);

/// The frames of a run that goes on, to be scrubbed through before the results are complete on disk. Stays within a
/// budget: when it is spent every second frame is let go and from then on only every second one is kept.
class LiveFrames {
 public:
  explicit LiveFrames(std::size_t budget_bytes = std::size_t{256} << 20) : budget_(budget_bytes) {}

  void clear();
  /// The newest frame is always kept, so that the view can follow the run.
  void add(std::shared_ptr<const Frame> frame);
  const std::vector<std::shared_ptr<const Frame>>& frames() const { return frames_; }

 private:
  void thin();

  std::size_t budget_, bytes_ = 0;
  int stride_ = 1;  ///< kept frames have an index divisible by it, apart from the newest
  std::vector<std::shared_ptr<const Frame>> frames_;
};

}  // namespace talus
