#include <gmock/gmock.h>

#include "verification/known_sample.hpp"

namespace talus {
namespace {

SampleOutcome slide(const CaseOptions& options) {
  NoProgress progress;
  for (const KnownSample& sample : find_known_samples(std::filesystem::path(TALUS_SOURCE_DIR) / "samples"))
    if (sample.name == "jiweishan") return run_sample(sample, options, progress);
  throw std::runtime_error("there is no such sample");
}

void expect_events_in_the_dynamic_stage(const SampleOutcome& outcome) {
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
}

TEST(Jiweishan, ComesToThePapersEventsInTheDynamicStage) { expect_events_in_the_dynamic_stage(slide({})); }

TEST(Jiweishan, ComesToThePapersEventsByThePapersScheme) {
  expect_events_in_the_dynamic_stage(slide({.preset = Preset::paper}));
}

}  // namespace
}  // namespace talus
