#include "study/accuracy/travel_watch.hpp"

#include <gtest/gtest.h>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

StudyTravel travel_in(const Project& project, const BlockSystem& system) {
  Simulation simulation(project, system);
  TravelWatch watch(project, system);
  while (!simulation.finished()) {
    const StepReport step = simulation.step();
    watch.look(step, simulation.bodies());
  }
  EXPECT_TRUE(simulation.converged());
  return watch.travel();
}

TEST(TravelWatch, TellsWhenABlockThatFallsSetsOffAndThatItHasNotCome) {
  Project project = test::rock_project(30, {{"fall", StageKind::dynamic, 0.001, 500, {}}});
  project.gravity = {0, 0, -10};
  const StudyTravel travel =
      travel_in(project, test::block_system({test::box_block("B", Vec3(0, 0, 0), Vec3(2, 2, 2), BodyKind::rigid)}));
  ASSERT_TRUE(travel.start);
  EXPECT_NEAR(*travel.start, std::sqrt(2 * 0.02 / 10), 2e-3) << "a hundredth of 2 m";
  EXPECT_FALSE(travel.end) << "it still falls";
  EXPECT_NEAR(travel.mean.z(), -1.25, 0.01);
  EXPECT_NEAR(travel.run_out, 0, 1e-12) << "that is horizontal";
}

/// Thrown along a slab of friction angle φ it goes on for v / (g tan φ), over v² / (2 g tan φ).
TEST(TravelWatch, TellsWhereAndWhenABlockThatSlidesComesToRest) {
  Project project = test::rock_project(30, {{"slide", StageKind::dynamic, 0.002, 750, {}}});
  project.gravity = {0, 0, -10};
  project.velocities = {{"B", Vec3(3, 0, 0), Vec3::Zero()}};
  const BlockSystem system =
      test::block_system({test::box_block("ground", Vec3(-5, -5, -1), Vec3(20, 5, 0), BodyKind::fixed),
                          test::box_block("B", Vec3(0, 0, 0), Vec3(4, 4, 0.5), BodyKind::rigid)});
  const StudyTravel travel = travel_in(project, system);
  const double deceleration = 10 * std::tan(M_PI / 6), stops = 3 / deceleration;
  ASSERT_TRUE(travel.start && travel.end);
  const double reach = 0.01 * 2;  // the block has 8 m³
  EXPECT_NEAR(*travel.start, reach / 3, 1e-3);
  EXPECT_LT(*travel.end, stops);
  EXPECT_GT(*travel.end, stops - std::sqrt(2 * reach / deceleration) - 2e-3) << "the last hundredth does not count";
  EXPECT_NEAR(travel.run_out, 9 / (2 * deceleration), 0.01);
  EXPECT_NEAR(travel.mean.x(), travel.run_out, 1e-3);
}

TEST(TravelWatch, TellsHowTheMassSpreads) {
  Project project = test::rock_project(30, {{"fly", StageKind::dynamic, 0.01, 100, {}}});
  project.gravity = Vec3::Zero();
  project.velocities = {{"A", Vec3(-1, 0, 0), Vec3::Zero()}, {"B", Vec3(3, 0, 0), Vec3::Zero()}};
  const BlockSystem system = test::block_system({test::box_block("A", Vec3(0, 0, 0), Vec3(1, 1, 1), BodyKind::rigid),
                                                 test::box_block("B", Vec3(4, 0, 0), Vec3(5, 1, 1), BodyKind::rigid)});
  const StudyTravel travel = travel_in(project, system);
  EXPECT_NEAR(travel.mean.x(), 1, 1e-9);
  EXPECT_NEAR(travel.extent_growth, 2, 1e-9) << "from 2 m on either side of the centre to 4";
  EXPECT_NEAR(travel.run_out, 3, 1e-9);
}

TEST(TravelWatch, CountsFromWhereStaticStagesEnd) {
  Project project = test::rock_project(
      40, {{"settle", StageKind::static_, 0.01, 20, {}}, {"rest", StageKind::dynamic, 0.01, 20, {}}});
  const StudyTravel travel = travel_in(project, test::cube_on_slab());
  EXPECT_FALSE(travel.start) << "it settles, and stays";
  EXPECT_FALSE(travel.end);
}

}  // namespace
}  // namespace talus
