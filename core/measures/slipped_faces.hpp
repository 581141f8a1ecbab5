#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include "base/progress.hpp"
#include "bodies/block_pose.hpp"
#include "results/result_folder.hpp"

namespace talus {

/// A plane in which two blocks lay against each other at rest, and slid on each other.
struct SlippedFace {
  std::array<int, 2> blocks;
  int joint = -1;              ///< index into BlockSystem::joint_names, of the contact that slid
  Vec3 normal = Vec3::Zero();  ///< unit, at rest, out of the first block
  double area = 0;             ///< m²
  double since = 0;            ///< s, of the first frame in which a contact on it slid
};

/// Looks for them frame by frame. Contacts that blocks made later, as when they landed, are on no such plane. Keeps a
/// reference to `system`.
class SlipWatch {
 public:
  explicit SlipWatch(const BlockSystem& system);
  void take(const Frame& frame);
  /// In the order in which they began.
  const std::vector<SlippedFace>& slipped() const { return slipped_; }

 private:
  const BlockSystem& system_;
  PoseFit fit_;
  std::vector<std::size_t> first_;                                  ///< node of each block
  std::map<std::array<int, 2>, std::vector<SlippedFace>> waiting_;  ///< that have not slid yet, by pairs of blocks
  std::vector<SlippedFace> slipped_;
};

/// Those of all frames. Throws Cancelled.
std::vector<SlippedFace> slipped_faces(const ResultReader& results, Progress& progress);

}  // namespace talus
