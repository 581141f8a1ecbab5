#pragma once

#include <vector>

#include "base/progress.hpp"
#include "results/result_folder.hpp"

namespace talus {

/// Where the centroid of each block is in each frame.
struct BlockTrails {
  std::vector<Vec3> rest;                   ///< m, a block, before anything moved
  std::vector<double> times;                ///< s, of frames
  std::vector<std::vector<Vec3>> centroid;  ///< m, a frame and in it a block
};

/// Of all frames that there are. Throws Cancelled, and InputError for a frame that cannot be read.
BlockTrails block_trails(const ResultReader& results, Progress& progress);

}  // namespace talus
