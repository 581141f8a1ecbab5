#pragma once

#include <memory>
#include <vector>

#include "base/progress.hpp"
#include "bodies/block_pose.hpp"
#include "results/result_folder.hpp"

namespace talus {

/// Where the centroid of each block is in each frame.
struct BlockTrails {
  std::vector<Vec3> rest;     ///< m, a block, before anything moved
  std::vector<double> times;  ///< s, of frames
  /// m, a frame and in it a block: shared, so that trails that go on are copied for little.
  std::vector<std::shared_ptr<const std::vector<Vec3>>> centroids;
};

/// Follows blocks from frame to frame, in the order of time.
class TrailTracer {
 public:
  explicit TrailTracer(std::shared_ptr<const BlockSystem> system);
  const std::shared_ptr<const BlockSystem>& system() const { return system_; }
  void add(const Frame& frame);
  /// As far as they have come.
  const BlockTrails& trails() const { return trails_; }

 private:
  std::shared_ptr<const BlockSystem> system_;
  PoseFit fit_;
  std::vector<std::size_t> first_;  ///< node of each block in a frame
  BlockTrails trails_;
};

/// Of all frames that there are. Throws Cancelled, and InputError for a frame that cannot be read.
BlockTrails block_trails(const ResultReader& results, Progress& progress);

}  // namespace talus
