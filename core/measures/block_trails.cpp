#include "measures/block_trails.hpp"

#include "measures/node_places.hpp"

namespace talus {

TrailTracer::TrailTracer(std::shared_ptr<const BlockSystem> system)
    : system_(std::move(system)), fit_(*system_), first_(first_nodes(*system_)) {
  for (std::size_t b = 0; b < system_->blocks.size(); ++b)
    trails_.rest.push_back(fit_.mean(static_cast<int>(b), system_->blocks[b].mesh.nodes.data()));
}

void TrailTracer::add(const Frame& frame) {
  std::vector<Vec3> centroids = trails_.rest;
  for (std::size_t b = 0; b < centroids.size(); ++b)
    if (!system_->blocks[b].mesh.nodes.empty())
      centroids[b] += fit_.mean(static_cast<int>(b), &frame.displacement[first_[b]]);
  trails_.times.push_back(frame.time);
  trails_.centroids.push_back(std::make_shared<const std::vector<Vec3>>(std::move(centroids)));
}

BlockTrails block_trails(const ResultReader& results, Progress& progress) {
  TrailTracer tracer(std::shared_ptr<const BlockSystem>(std::shared_ptr<void>(), &results.system()));
  const std::size_t count = results.frame_times().size();
  for (std::size_t number = 0; number < count; ++number) {
    if (progress.cancelled()) throw Cancelled{};
    progress.report(static_cast<double>(number) / static_cast<double>(count), "following the blocks");
    tracer.add(results.frame(static_cast<int>(number)));
  }
  return tracer.trails();
}

}  // namespace talus
