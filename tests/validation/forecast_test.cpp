#include "study/forecast/forecast.hpp"

#include <gtest/gtest.h>

#include "base/processor_time.hpp"
#include "base/temporary_folder.hpp"
#include "geometry/block_builder.hpp"
#include "io/project_file.hpp"
#include "run/run.hpp"
#include "support/silent_observer.hpp"

namespace talus {
namespace {

/// What is foreseen of a sample against what its run then takes, both in the processor's time of one thread.
class ForecastOfSample : public ::testing::TestWithParam<const char*> {};

TEST_P(ForecastOfSample, IsWithin30PercentOfTheRun) {
  const std::string name = GetParam();
  const auto folder = std::filesystem::path(TALUS_SOURCE_DIR) / "samples" / name;
  const Project project = read_project(folder / (name + ".talus"));
  NoProgress progress;
  const BlockSystem system = build_blocks(project, folder, progress);
  constexpr double budget = 4;
  const Forecast said = forecast(project, system, budget, progress);
  const TemporaryFolder results;
  SilentObserver observer;
  const double begin = processor_seconds_of_thread();
  run(project, system, {results.path() / "results", write_project(project), 1}, observer);
  const double measured = processor_seconds_of_thread() - begin;
  std::printf("| `%s` | %.3g | %.3g to %.3g | %.3g | %.2f | %.0f %% | %.2g |\n", name.c_str(), said.seconds,
              said.fewest, said.most, measured, said.seconds / measured, 100 * said.share_seen, said.forecast_seconds);
  EXPECT_LT(said.seconds, 1.3 * measured);
  EXPECT_GT(said.seconds, measured / 1.3);
  EXPECT_LT(said.fewest, measured * 1.1) << "twice the same work differs by some per cent in time";
  EXPECT_GT(said.most, measured / 1.1);
}

INSTANTIATE_TEST_SUITE_P(Long, ForecastOfSample,
                         ::testing::Values("block_ladder", "free_fall", "incline_slide", "incline_stay", "jiweishan",
                                           "step_slope", "wedge"));

}  // namespace
}  // namespace talus
