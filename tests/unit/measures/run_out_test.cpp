#include "measures/run_out.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/error.hpp"
#include "base/units.hpp"
#include "unit/measures/slid_boxes.hpp"

// How far boxes went that were moved by known vectors.
namespace talus {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// The slab onto the floor 6 m east, the tower 4 m east.
const std::vector<Vec3> ways{{0, 0, 0}, {6, 0, -10}, {4, 0, -20}, {0, 0.1, 0}};

TEST(MovedRock, IsWhatWentFurtherThanAHundredthOfTheModelsDiagonal) {
  const BlockSystem system = floor_and_boxes();
  const MovedRock rock = moved_rock(system, moved_frame(system, ways, at_rest));
  EXPECT_THAT(rock.blocks, ElementsAre(1, 2));
  EXPECT_NEAR(rock.further_than, Vec3(40, 20, 24).norm() / 100, 1e-12);
  EXPECT_NEAR(rock.volume, 7, 1e-12);
  EXPECT_NEAR((rock.displacement - Vec3(36, 0, -100) / 7).norm(), 0, 1e-12);
  EXPECT_NEAR((rock.forward - Vec3::UnitX()).norm(), 0, 1e-12);
}

TEST(MovedRock, FollowsTheLengthThatIsGiven) {
  const BlockSystem system = floor_and_boxes();
  const Frame frame = moved_frame(system, ways, at_rest);
  EXPECT_THAT(moved_rock(system, frame, {.moved = 0.09, .azimuth = {}}).blocks, ElementsAre(1, 2, 3));
  EXPECT_THAT(moved_rock(system, frame, {.moved = 0.11, .azimuth = {}}).blocks, ElementsAre(1, 2));
  EXPECT_THAT(moved_rock(system, frame, {.moved = 30, .azimuth = {}}).blocks, IsEmpty());
  EXPECT_THROW(moved_rock(system, frame, {.moved = -1, .azimuth = {}}), InputError);
  EXPECT_THROW(moved_rock(system, frame, {.moved = NAN, .azimuth = {}}), InputError);
  EXPECT_THROW(moved_rock(system, frame, {.moved = {}, .azimuth = NAN}), InputError);
}

TEST(MovedRock, DoesNotCountABaseThatIsMoved) {
  const BlockSystem system = floor_and_boxes();
  const Frame frame = moved_frame(system, std::vector<Vec3>(4, Vec3(5, 0, 0)), at_rest);
  EXPECT_THAT(moved_rock(system, frame).blocks, ElementsAre(1, 2, 3));
}

TEST(RunOut, IsThatOfTheBlocksWhichWentFarthest) {
  const BlockSystem system = floor_and_boxes();
  const RunOut found = run_out(system, moved_frame(system, ways, at_rest));
  EXPECT_EQ(found.in_space.block, 2);
  EXPECT_NEAR(found.in_space.length, std::hypot(4, 20), 1e-12);
  EXPECT_EQ(found.in_plan.block, 1);
  EXPECT_NEAR(found.in_plan.length, 6, 1e-12);
  EXPECT_EQ(found.forward.block, 1);
  EXPECT_NEAR(found.forward.length, 6, 1e-12);
  EXPECT_NEAR(found.front, 6, 1e-12);
}

TEST(RunOut, HasTheTravelAngleFromTheCrownToTheToe) {
  const BlockSystem system = floor_and_boxes();
  const RunOut found = run_out(system, moved_frame(system, ways, at_rest));
  EXPECT_NEAR((found.crown_to_toe.from - Vec3(-4, 0, 23)).norm(), 0, 1e-12);
  EXPECT_NEAR((found.crown_to_toe.to - Vec3(8, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(found.crown_to_toe.angle(), degrees(std::atan2(23, 12)), 1e-12);
  EXPECT_NEAR(found.of_centre.angle(), degrees(std::atan2(100, 36)), 1e-9);
}

// A block that slides down a plane and along the level, and comes to rest: the height of its centre's fall over its
// way in plan is the coefficient of friction.
TEST(RunOut, OfACentreThatFrictionStoppedIsTheAngleOfFriction) {
  const double friction = std::tan(radians(20)), fall = 7;
  const BlockSystem system = floor_and_boxes();
  const RunOut found =
      run_out(system, moved_frame(system, {{0, 0, 0}, {0, fall / friction, -fall}, {0, 0, 0}, {0, 0, 0}}, at_rest));
  EXPECT_NEAR(found.of_centre.angle(), 20, 1e-9);
}

TEST(RunOut, LooksForwardAsItIsTold) {
  const BlockSystem system = floor_and_boxes();
  const RunOut found = run_out(system, moved_frame(system, ways, at_rest), {.moved = {}, .azimuth = 90 + 60});
  EXPECT_NEAR(found.forward.length, 3, 1e-12) << "6 m east, seen 60° to the side";
  EXPECT_EQ(found.in_plan.length, 6);
}

TEST(RunOut, OfRockThatFellStraightDownHasNoForward) {
  const BlockSystem system = floor_and_boxes();
  const RunOut found = run_out(system, moved_frame(system, {{0, 0, 0}, {0, 0, -10}, {0, 0, 0}, {0, 0, 0}}, at_rest));
  EXPECT_EQ(found.rock.forward, Vec3(Vec3::Zero()));
  EXPECT_EQ(found.front, 0);
  EXPECT_NEAR(found.of_centre.angle(), 90, 1e-9);
}

TEST(RunOut, OfRockThatStayedIsNothing) {
  const BlockSystem system = floor_and_boxes();
  const RunOut found = run_out(system, moved_frame(system, at_rest, at_rest));
  EXPECT_THAT(found.rock.blocks, IsEmpty());
  EXPECT_EQ(found.in_space.block, -1);
  EXPECT_EQ(found.front, 0);
}

TEST(FrontHistory, HasTheVelocityOfThePointThatIsForemost) {
  const BlockSystem system = floor_and_boxes();
  const FrontHistory front(system, moved_rock(system, moved_frame(system, ways, at_rest)));
  const FrontMoment slab_leads = front.at(
      moved_frame(system, {{0, 0, 0}, {2, 0, -1}, {0, 0, 0}, {0, 0, 0}}, {still, {3, 4, -5}, {9, 0, 0}, still}, 1.5));
  EXPECT_EQ(slab_leads.time, 1.5);
  EXPECT_NEAR(slab_leads.advance, 2, 1e-12);
  EXPECT_NEAR(slab_leads.velocity, 3, 1e-12);
  EXPECT_NEAR(slab_leads.volume, 4, 1e-12) << "the tower has not moved yet";
  const FrontMoment tower_leads = front.at(
      moved_frame(system, {{0, 0, 0}, {2, 0, -1}, {8, 0, 0}, {0, 0, 0}}, {still, {3, 4, -5}, {9, 0, 0}, still}, 2));
  EXPECT_NEAR(tower_leads.advance, 3, 1e-12) << "from x = 2 at rest to x = 5";
  EXPECT_NEAR(tower_leads.velocity, 9, 1e-12);
  EXPECT_NEAR(tower_leads.volume, 7, 1e-12);
}

}  // namespace
}  // namespace talus
