#include <gmock/gmock.h>

#include "verification/known_sample.hpp"

namespace talus {
namespace {

TEST(Jiweishan, ComesToThePapersEventsInTheDynamicStage) {
  NoProgress progress;
  const auto samples = find_known_samples(std::filesystem::path(TALUS_SOURCE_DIR) / "samples");
  for (const KnownSample& sample : samples) {
    if (sample.name != "jiweishan") continue;
    const SampleOutcome outcome = run_sample(sample, {}, progress);
    EXPECT_EQ(outcome.report.status, RunStatus::completed) << outcome.report.reason;
    ASSERT_EQ(outcome.events.size(), 5U);
    for (const EventComparison& event : outcome.events) {
      EXPECT_TRUE(event.computed) << event.event.what << " did not happen";
      if (event.computed) {
        EXPECT_GT(*event.computed, 40) << event.event.what << " belongs to the dynamic stage";
      }
    }
    EXPECT_TRUE(in_published_order(outcome.events));
    EXPECT_LT(outcome.report.cuts, 0.01 * outcome.report.steps) << "hardly a step is cut";
    EXPECT_LT(outcome.report.iterations, 4 * outcome.report.steps) << "iterations: two or three a step";
    return;
  }
  FAIL() << "there is no such sample";
}

}  // namespace
}  // namespace talus
