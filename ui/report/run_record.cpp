#include "report/run_record.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "base/error.hpp"
#include "results/energy_moved.hpp"

namespace talus::report {

namespace {

Frame last_frame(const ResultReader& results) {
  const int frames = static_cast<int>(results.frame_times().size());
  if (frames == 0) throw InputError("frames", "the results hold no frame yet", "wait for the run to write one");
  return results.frame(frames - 1);
}

std::vector<BlockTravel> farthest_first(const BlockSystem& system, const Frame& frame) {
  std::vector<BlockTravel> travels = block_travels(system, frame);
  std::erase_if(travels, [&](const BlockTravel& travel) {
    return system.blocks[static_cast<std::size_t>(travel.block)].body == BodyKind::fixed;
  });
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
      travels(farthest_first(results.system(), last)) {}

double energy_moved(const std::vector<StepReport>& steps) {
  double most = 0;
  for (const StepReport& step : steps) most = std::max(most, largest_account(step.energy));
  return most;
}

}  // namespace talus::report
