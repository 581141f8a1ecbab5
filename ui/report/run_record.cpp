#include "report/run_record.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "base/units.hpp"
#include "bodies/block_pose.hpp"
#include "results/energy_moved.hpp"

namespace talus::report {

namespace {

Frame last_frame(const ResultReader& results) {
  const int frames = static_cast<int>(results.frame_times().size());
  if (frames == 0) throw InputError("frames", "the results hold no frame yet", "wait for the run to write one");
  return results.frame(frames - 1);
}

std::vector<BlockTravel> travels_in(const BlockSystem& system, const Frame& frame) {
  const PoseFit fit(system);
  std::vector<BlockTravel> travels;
  std::size_t first = 0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const Block& block = system.blocks[b];
    const std::size_t count = block.mesh.nodes.size();
    if (block.body != BodyKind::fixed && count > 0) {
      const int number = static_cast<int>(b);
      std::vector<Vec3> positions = block.mesh.nodes;
      for (std::size_t n = 0; n < count; ++n) positions[n] += frame.displacement[first + n];
      const BlockPose pose = fit.pose(number, block.mesh.nodes.data(), positions.data());
      travels.push_back({number, fit.mean(number, &frame.displacement[first]), fit.mean(number, &frame.velocity[first]),
                         degrees(Eigen::AngleAxisd(pose.rotation).angle())});
    }
    first += count;
  }
  std::ranges::stable_sort(travels, std::greater{},
                           [](const BlockTravel& travel) { return travel.displacement.norm(); });
  return travels;
}

}  // namespace

RunRecord::RunRecord(const std::filesystem::path& folder, ProjectOfRun kept)
    : results(folder),
      report(results.report()),
      project(std::move(kept.project)),
      why_no_project(std::move(kept.why_not)),
      steps(results.steps()),
      history(results.history()),
      last(last_frame(results)),
      travels(travels_in(results.system(), last)) {}

double energy_moved(const std::vector<StepReport>& steps) {
  double most = 0;
  for (const StepReport& step : steps) most = std::max(most, largest_account(step.energy));
  return most;
}

}  // namespace talus::report
