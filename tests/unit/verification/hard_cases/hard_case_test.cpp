#include "verification/hard_cases/hard_case.hpp"

#include <gtest/gtest.h>

#include "verification/known_answers/support/scene.hpp"

namespace talus {
namespace {

HardCase falling_cube() {
  return {.name = "falling_cube", .group = "group", .title = "Title", .expected = {}, .build = [] {
            CaseScene scene = rock_scene(30);
            scene.add_box("cube", Vec3(0, 0, 0), Vec3(1, 1, 1));
            scene.project.velocities = {{.block = "cube", .linear = {3, 0, 0}, .angular = {0, 2, 0}}};
            return scene;
          }};
}

TEST(HardCase, IsPerturbedByAHairEachTimeFurther) {
  const auto scenes = with_perturbations(falling_cube(), 2);
  ASSERT_EQ(scenes.size(), 3u);
  EXPECT_EQ(scenes[0].name, "falling_cube");
  EXPECT_EQ(scenes[2].name, "falling_cube+2");
  const Project as_it_is = scenes[0].build().project, twice = scenes[2].build().project;
  EXPECT_EQ(as_it_is, falling_cube().build().project);
  EXPECT_NEAR(twice.gravity.z() / as_it_is.gravity.z() - 1, 2e-10, 1e-15);
  EXPECT_NEAR(twice.velocities[0].linear.x() / 3 - 1, 2e-10, 1e-15);
  EXPECT_NEAR(twice.velocities[0].angular.y() / 2 - 1, 2e-10, 1e-15);
}

TEST(HardCase, ThatIsNotPerturbedStandsAlone) { EXPECT_EQ(with_perturbations(falling_cube(), 0).size(), 1u); }

}  // namespace
}  // namespace talus
