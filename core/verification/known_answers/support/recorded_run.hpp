#pragma once

#include <functional>
#include <vector>

#include "bodies/block_motion.hpp"
#include "verification/known_answers/support/known_case.hpp"
#include "verification/known_answers/support/scene.hpp"

/// Where the blocks of a scene were when.
namespace talus {

/// All blocks at the end of a step.
struct Snapshot {
  double time = 0;  ///< s
  int stage = 0;
  std::vector<BlockMotion> blocks;
};

/// Runs the scene at the scale asked for and says what happened as it would have been at full size: lengths ÷ s, times
/// and velocities ÷ √s. `go_on` may end the run early; it is asked after every step.
std::vector<Snapshot> record(const CaseScene& scene, const CaseOptions& options, Progress& progress,
                             const std::function<bool(const Snapshot&)>& go_on = {});

/// How far the block has gone that went farthest from one snapshot to another [m].
double farthest(const Snapshot& from, const Snapshot& to);

/// Whether any block goes farther than `distance` [m, at full size] after the first stage, a static one; ends the run
/// when one does.
bool sets_off(const CaseScene& scene, double distance, const CaseOptions& options, Progress& progress);

}  // namespace talus
