#include "verification/known_answers/support/recorded_run.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

std::vector<Snapshot> record(const CaseScene& scene, const CaseOptions& options, Progress& progress,
                             const std::function<bool(const Snapshot&)>& go_on) {
  const double s = options.scale, root = std::sqrt(s);
  std::vector<Snapshot> snapshots;
  run_scene(as_asked(scene, options), progress, [&](const Simulation& simulation, const StepReport& report) {
    Snapshot snapshot{simulation.time() / root, report.stage, {}};
    for (std::size_t b = 0; b < scene.system.blocks.size(); ++b) {
      BlockMotion block = block_motion(simulation.bodies(), static_cast<int>(b));
      block.displacement /= s;
      block.velocity /= root;
      snapshot.blocks.push_back(block);
    }
    snapshots.push_back(std::move(snapshot));
    return !go_on || go_on(snapshots.back());
  });
  return snapshots;
}

double farthest(const Snapshot& from, const Snapshot& to) {
  double distance = 0;
  for (std::size_t b = 0; b < from.blocks.size(); ++b)
    distance = std::max(distance, (to.blocks[b].displacement - from.blocks[b].displacement).norm());
  return distance;
}

bool sets_off(const CaseScene& scene, double distance, const CaseOptions& options, Progress& progress) {
  Snapshot after_static;
  bool off = false;
  record(scene, options, progress, [&](const Snapshot& snapshot) {
    if (snapshot.stage == 0)
      after_static = snapshot;
    else
      off = farthest(after_static, snapshot) > distance;
    return !off;
  });
  return off;
}

}  // namespace talus
