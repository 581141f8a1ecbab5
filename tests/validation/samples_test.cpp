#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "io/project_file.hpp"
#include "verification/known_sample.hpp"

namespace talus {
namespace {

const std::filesystem::path folder = std::filesystem::path(TALUS_SOURCE_DIR) / "samples";

KnownSample sample(const std::string& name) {
  const auto samples = find_known_samples(folder);
  const auto found = std::find_if(samples.begin(), samples.end(), [&](const auto& s) { return s.name == name; });
  if (found == samples.end()) throw std::runtime_error("no sample " + name);
  return *found;
}

/// The tolerances are those of docs/validation.md, not what happens to come out: a sample may not widen them.
void expect_tolerances_within(const std::string& name, double relative, double absolute) {
  const std::vector<Expectation> expected = read_project(sample(name).project).expect;
  ASSERT_FALSE(expected.empty());
  for (const Expectation& one : expected)
    EXPECT_LE(one.tolerance, one.value == 0 ? absolute : relative) << one.quantity;
}

TEST(Samples, QuickOnesHaveAnswersAndJiweishanTakesLong) {
  std::vector<std::string> quick, slow;
  for (const KnownSample& s : find_known_samples(folder)) (s.takes_long ? slow : quick).push_back(s.name);
  EXPECT_THAT(quick, testing::ElementsAre("arch", "block_ladder", "cantilever", "free_fall", "incline_slide",
                                          "incline_stay", "spinning_block", "wedge"));
  EXPECT_THAT(slow, testing::ElementsAre("jiweishan"));
}

TEST(Samples, ThatAskForStressAreOfOneBody) {
  std::vector<std::string> of_one_body;
  for (const KnownSample& s : find_known_samples(folder))
    if (!case_of(s).of_any_body) of_one_body.push_back(s.name);
  EXPECT_THAT(of_one_body, testing::ElementsAre("arch", "cantilever", "jiweishan"));
}

TEST(Samples, AreHeldToTheTolerancesOfTheMethod) {
  expect_tolerances_within("free_fall", 1e-10, 1e-10);
  expect_tolerances_within("incline_slide", 1e-3, 1e-6);
  expect_tolerances_within("block_ladder", 1e-3, 1e-6);
  expect_tolerances_within("incline_stay", 0, 1e-9);
  expect_tolerances_within("wedge", 1e-2, 0);
  expect_tolerances_within("spinning_block", 1e-3, 1e-3);
  expect_tolerances_within("cantilever", 2e-2, 0);
  expect_tolerances_within("arch", 1e-2, 1e-6);
}

TEST(Samples, WedgeSlidesAlongTheLineOfIntersection) {
  // Two degrees are asked for; the line is (0.45808, 0.48671, −0.74383).
  const Vec3 line(0.45807866745109466, 0.4867085841667879, -0.743827055520697);
  NoProgress progress;
  const RunReport report = run_sample(sample("wedge"), {}, progress).report;
  ASSERT_EQ(report.status, RunStatus::completed) << report.reason;
  const auto wedge = std::ranges::find(report.blocks, "wedge", &BlockOutcome::name);
  ASSERT_NE(wedge, report.blocks.end());
  EXPECT_GT(wedge->velocity.norm(), 0.2) << "m/s";
  EXPECT_GT(wedge->velocity.normalized().dot(line), 0.999391);
}

/// The run of a sample without a known answer, which must come to its end.
RunReport completed(const std::string& name) {
  NoProgress progress;
  KnownSample sample;
  sample.project = folder / name / (name + ".talus");
  const RunReport report = run_sample(sample, {}, progress).report;
  EXPECT_EQ(report.status, RunStatus::completed) << report.reason;
  return report;
}

/// No answer is known for the slope from a STEP file: it must come to its end, both halves must slide, and nothing may
/// tunnel. Blocks that strike the bench at 20 m/s go 0.1 m in a step of 0.005 s.
TEST(Samples, BlocksOfTheStepSlopeSlideOutAndNothingTunnels) {
  const RunReport report = completed("step_slope");
  EXPECT_LT(report.max_relative_penetration, 0.01);
  std::vector<std::string> moved;
  for (const BlockOutcome& block : report.blocks) {
    EXPECT_LT(std::abs(block.relative_volume_change), 1e-4) << block.name;
    if (block.displacement.x() > 20 && block.displacement.z() < -10) moved.push_back(block.name);
  }
  EXPECT_THAT(moved, testing::UnorderedElementsAre("front south", "front north", "rear south", "rear north"));
}

/// Nor for the bench: where its blocks come to lie is chance.
TEST(JointedBench, SlidesOutFallsAndComesToRestAndNothingTunnels) {
  const RunReport report = completed("jointed_bench");
  EXPECT_LT(report.max_relative_penetration, 0.05);
  const EnergyLedger& energy = report.last_step.energy;
  EXPECT_LT(std::abs(energy.remainder), 1e-6 * std::abs(energy.potential));
  EXPECT_LT(energy.kinetic, 1e-3 * std::abs(energy.potential)) << "one block may still topple";
  EXPECT_EQ(std::ranges::count_if(report.blocks, [](const auto& block) { return block.displacement.z() < -3; }), 247);
}

}  // namespace
}  // namespace talus
