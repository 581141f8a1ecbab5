#include "run/event_watch.hpp"

#include <gmock/gmock.h>

#include "solve/simulation.hpp"
#include "support/small_scenes.hpp"

namespace talus {
namespace {

TEST(EventWatch, TellsThatAJointOpensOnceAndThatItsBlockFallsFree) {
  // A block slides off a table's edge: it starts half over it, pushed out by its velocity, and falls.
  Project project;
  project.materials = {{"rock", 2600, 5e9, 0.24}};
  project.joints = {{"J", 0, 0, 0, {}, {}, {}, {}}};
  project.default_joint = "J";
  project.stages = {{"push", StageKind::dynamic, 0.01, 150, {}}};
  project.velocities = {{"B", Vec3(2, 0, 0), Vec3::Zero()}};
  BlockSystem system;
  system.joint_names = {"J"};
  system.blocks = {test::box_block("table", Vec3(-3, -2, -0.5), Vec3(0, 3, 0), BodyKind::fixed),
                   test::box_block("B", Vec3(-1, 0, 0), Vec3(0, 1, 0.5))};
  system.solids_volume = 8;
  Simulation simulation(project, system);
  EventWatch watch(system);
  while (!simulation.finished()) {
    simulation.step();
    watch.look(simulation);
  }
  ASSERT_TRUE(simulation.converged()) << simulation.failure();
  std::vector<std::string> told;
  for (const Event& event : watch.events()) told.push_back(event.what);
  EXPECT_THAT(told, testing::IsSupersetOf({"J opens (table - B)", "B falls free", "B topples (turned by 10°)"}));
  EXPECT_EQ(std::count(told.begin(), told.end(), "J opens (table - B)"), 1);
  for (const Event& event : watch.events()) EXPECT_GT(event.time, 0.2) << event.what;
}

TEST(EventWatch, ABlockThatWasAsleepFliesFromWhenItWoke) {
  // It rests for a second and is thrown up in the next stage.
  Project project;
  project.materials = {{"rock", 2600, 5e9, 0.24}};
  project.joints = {{"J", 30, 0, 0, {}, {}, {}, {}}};
  project.default_joint = "J";
  Stage rest{"rest", StageKind::dynamic, 0.01, 100, {}}, fly{"fly", StageKind::dynamic, 0.01, 60, {}};
  fly.loads = std::vector<PointLoad>{{"B", Vec3(0.5, 0.5, 0.5), Vec3(0, 0, 3 * 9.81 * 2600), {}}};
  project.stages = {rest, fly};
  BlockSystem system;
  system.joint_names = {"J"};
  system.blocks = {test::box_block("table", Vec3(-3, -2, -0.5), Vec3(3, 3, 0), BodyKind::fixed),
                   test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1))};
  system.solids_volume = 8;
  Simulation simulation(project, system);
  EventWatch watch(system);
  int most_asleep = 0;
  while (!simulation.finished()) {
    most_asleep = std::max(most_asleep, simulation.step().asleep);
    watch.look(simulation);
  }
  ASSERT_TRUE(simulation.converged()) << simulation.failure();
  EXPECT_EQ(most_asleep, 1);
  int told = 0;
  for (const Event& event : watch.events()) {
    if (event.what != "B falls free") continue;
    ++told;
    EXPECT_NEAR(event.time, 1, 0.05);
  }
  EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace talus
