#include "measures/block_trails.hpp"

#include "bodies/block_pose.hpp"
#include "measures/node_places.hpp"

namespace talus {

BlockTrails block_trails(const ResultReader& results, Progress& progress) {
  const BlockSystem& system = results.system();
  const PoseFit fit(system);
  const std::vector<std::size_t> first = first_nodes(system);
  BlockTrails trails;
  for (std::size_t b = 0; b < system.blocks.size(); ++b)
    trails.rest.push_back(fit.mean(static_cast<int>(b), system.blocks[b].mesh.nodes.data()));
  trails.times = results.frame_times();
  for (std::size_t number = 0; number < trails.times.size(); ++number) {
    if (progress.cancelled()) throw Cancelled{};
    progress.report(static_cast<double>(number) / static_cast<double>(trails.times.size()), "following the blocks");
    const Frame frame = results.frame(static_cast<int>(number));
    std::vector<Vec3>& centroid = trails.centroid.emplace_back(trails.rest);
    for (std::size_t b = 0; b < centroid.size(); ++b)
      if (!system.blocks[b].mesh.nodes.empty())
        centroid[b] += fit.mean(static_cast<int>(b), &frame.displacement[first[b]]);
  }
  return trails;
}

}  // namespace talus
