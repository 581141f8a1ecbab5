#include "verification/known_answers/support/recorded_run.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/stages.hpp"
#include "verification/known_answers/support/bracket.hpp"

namespace talus {
namespace {

CaseScene falling_block() {
  CaseScene scene = rock_scene(30);
  scene.add_box("block", Vec3(0, 0, 0), Vec3(1, 1, 1));
  scene.project.stages = {dynamic_stage(0.01, 1)};
  return scene;
}

TEST(RecordedRun, SpeaksOfFullSizeAtAnyScale) {
  NoProgress nobody;
  for (const double scale : {1.0, 0.1}) {
    const Snapshot last = record(falling_block(), {.scale = scale}, nobody).back();
    EXPECT_NEAR(last.time, 1, 1e-12);
    EXPECT_NEAR(last.blocks[0].displacement.z(), -0.5 * 9.81, 0.1);
    EXPECT_NEAR(last.blocks[0].velocity.z(), -9.81, 0.1);
  }
}

/// Counts the steps of a run, which asks before each whether to go on.
class Counting final : public Progress {
 public:
  void report(double, std::string_view) override {}
  bool cancelled() const override { return ++steps < 0; }
  mutable int steps = 0;
};

TEST(RecordedRun, EndsWhenItSetsOff) {
  Counting first, second;
  CaseScene scene = falling_block();
  scene.project.stages.insert(scene.project.stages.begin(), static_stage(0.01, 1));
  EXPECT_TRUE(sets_off(scene, 1, {}, first));
  EXPECT_NEAR(first.steps, 100 * std::sqrt(2 / 9.81), 3) << "a fall of 1 m, of a run of 101 steps";
  EXPECT_FALSE(sets_off(scene, 10, {}, second));
  EXPECT_GE(second.steps, 101);
}

TEST(Bracket, ClosesInOnWhatDividesIt) {
  const Bracket bracket = narrowed({0, 16}, 10, [](double x) { return x < 3.3; });
  EXPECT_LT(bracket.falls, 3.3);
  EXPECT_GE(bracket.stands, 3.3);
  EXPECT_NEAR(bracket.stands - bracket.falls, 16.0 / 1024, 1e-12);
}

TEST(KnownCase, HasFindingsThatScaleWithTheirUnit) {
  const KnownCase known = at_any_scale({.name = "c", .title = "", .source = "", .run = [](auto&, auto&) {
                                          CaseOutcome outcome;
                                          for (const char* unit : {"m", "s", "m/s", "m/s²", ""})
                                            for (const bool absolute : {false, true})
                                              outcome.findings.push_back({.quantity = unit,
                                                                          .unit = unit,
                                                                          .expected = 2,
                                                                          .computed = 3,
                                                                          .tolerance = 0.5,
                                                                          .absolute = absolute});
                                          return outcome;
                                        }});
  NoProgress nobody;
  const CaseOutcome small = known.run({.scale = 0.01}, nobody);
  const double factors[] = {0.01, 0.1, 0.1, 1, 1};
  for (int i = 0; i < 5; ++i) {
    const Finding &relative = small.findings[2 * i], &absolute = small.findings[2 * i + 1];
    EXPECT_NEAR(relative.expected, 2 * factors[i], 1e-12);
    EXPECT_NEAR(relative.computed, 3 * factors[i], 1e-12);
    EXPECT_EQ(relative.tolerance, 0.5);
    EXPECT_NEAR(absolute.tolerance, 0.5 * factors[i], 1e-12);
  }
}

}  // namespace
}  // namespace talus
