#include "cases/block_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace talus {
namespace {

CaseScene falling_block() {
  CaseScene scene = rock_scene(30);
  add_box(scene, "block", Vec3(0, 0, 0), Vec3(1, 1, 1));
  scene.project.stages = {motion(0.01, 1)};
  return scene;
}

TEST(BlockScene, a_record_speaks_of_full_size_at_any_scale) {
  NoProgress nobody;
  for (const double scale : {1.0, 0.1}) {
    const Moment last = record(falling_block(), {.scale = scale}, nobody).back();
    EXPECT_NEAR(last.time, 1, 1e-12);
    EXPECT_NEAR(last.blocks[0].displacement.z(), -0.5 * 9.81, 0.1);
    EXPECT_NEAR(last.blocks[0].velocity.z(), -9.81, 0.1);
  }
}

TEST(BlockScene, sets_off_ends_the_run_at_the_distance) {
  NoProgress nobody;
  CaseScene scene = falling_block();
  scene.project.stages.insert(scene.project.stages.begin(), settling(0.01, 1));
  EXPECT_TRUE(sets_off(scene, 1, {}, nobody));
  EXPECT_FALSE(sets_off(scene, 10, {}, nobody));
}

TEST(BlockScene, a_bracket_closes_in_on_what_divides_it) {
  const Bracket bracket = narrowed({0, 16}, 10, [](double x) { return x < 3.3; });
  EXPECT_LT(bracket.falls, 3.3);
  EXPECT_GE(bracket.stands, 3.3);
  EXPECT_NEAR(bracket.stands - bracket.falls, 16.0 / 1024, 1e-12);
}

TEST(BlockScene, findings_scale_with_their_unit) {
  const KnownCase known = at_any_scale(
      {.name = "c", .title = "", .source = "", .run = [](auto&, auto&) {
         CaseOutcome outcome;
         for (const char* unit : {"m", "s", "m/s", "m/s²", ""})
           outcome.findings.push_back({.quantity = unit, .unit = unit, .expected = 2, .computed = 3, .tolerance = 0.5});
         return outcome;
       }});
  NoProgress nobody;
  const CaseOutcome small = known.run({.scale = 0.01}, nobody);
  const double factors[] = {0.01, 0.1, 0.1, 1, 1};
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(small.findings[i].expected, 2 * factors[i], 1e-12);
    EXPECT_NEAR(small.findings[i].computed, 3 * factors[i], 1e-12);
  }
}

}  // namespace
}  // namespace talus
