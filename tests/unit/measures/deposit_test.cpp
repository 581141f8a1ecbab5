#include "measures/deposit.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/error.hpp"
#include "unit/measures/slid_boxes.hpp"

// Deposits of boxes, whose area, depth and outline are known.
namespace talus {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::SizeIs;
using testing::UnorderedElementsAre;

Deposit of(const BlockSystem& system, const std::vector<Vec3>& ways, std::optional<double> cell = 0.5) {
  const Frame frame = moved_frame(system, ways, std::vector<Vec3>(system.blocks.size(), Vec3::Zero()));
  return deposit_of(system, frame, moved_rock(system, frame), cell);
}

/// m², negative of a ring that runs clockwise.
double area_of(const PlanRing& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

std::vector<double> areas_of(const std::vector<PlanRing>& rings) {
  std::vector<double> areas;
  for (const PlanRing& ring : rings) areas.push_back(area_of(ring));
  return areas;
}

TEST(Deposit, OfTwoBoxesOnAFloorHasTheirPlansAndHeights) {
  const Deposit deposit = of(floor_and_boxes(), {{0, 0, 0}, {6, 0, -10}, {4, 0, -20}, {0, 0, 0}});
  EXPECT_NEAR(deposit.area, 5, 1e-12);
  EXPECT_NEAR(deposit.bulk, 7, 1e-12);
  EXPECT_NEAR(deposit.mean_depth, 1.4, 1e-12);
  EXPECT_NEAR(deposit.max_depth, 3, 1e-12);
  EXPECT_THAT(areas_of(deposit.outline), UnorderedElementsAre(DoubleNear(4, 1e-12), DoubleNear(1, 1e-12)));
  EXPECT_THAT(deposit.outline[0],
              ElementsAre(ElementsAre(0, 0), ElementsAre(1, 0), ElementsAre(1, 1), ElementsAre(0, 1)));
}

TEST(Deposit, OfABoxOnAnotherIsAsDeepAsBoth) {
  const Deposit deposit = of(floor_and_boxes(), {{0, 0, 0}, {6, 0, -10}, {10.5, 0.5, -19}, {0, 0, 0}});
  EXPECT_NEAR(deposit.area, 4, 1e-12);
  EXPECT_NEAR(deposit.max_depth, 4, 1e-12);
  EXPECT_NEAR(deposit.bulk, 3 * 1 + 1 * 4, 1e-12);
}

TEST(Deposit, CountsTheVoidBelowABridge) {
  const Deposit deposit = of(floor_and_boxes(), {{0, 0, 0}, {9, 0, -8}, {0, 0, 0}, {0, 0, 0}});
  // Over the floor at 0, and over the block that stayed between x = 10 and 11, y = 0 and 1, whose top is at 1.
  EXPECT_NEAR(deposit.bulk, 3 * 3 + 1 * 2, 1e-12);
}

TEST(Deposit, WithoutGroundBelowIsAsDeepAsItIsThick) {
  const Deposit deposit = of(floor_and_boxes(), {{0, 0, 0}, {30, 0, -200}, {0, 0, 0}, {0, 0, 0}});
  EXPECT_NEAR(deposit.max_depth, 1, 1e-12);
}

TEST(Deposit, ThatLeavesAPlaceFreeHasARingAroundIt) {
  BlockSystem system;
  system.blocks = {box_block("south", {0, 0, 0}, {3, 1, 1}, BodyKind::rigid),
                   box_block("north", {0, 2, 0}, {3, 1, 1}, BodyKind::rigid),
                   box_block("west", {0, 1, 0}, {1, 1, 1}, BodyKind::rigid),
                   box_block("east", {2, 1, 0}, {1, 1, 1}, BodyKind::rigid)};
  const Deposit deposit = of(system, std::vector<Vec3>(4, Vec3(5, 5, 0)), 0.25);
  EXPECT_THAT(areas_of(deposit.outline), UnorderedElementsAre(DoubleNear(9, 1e-12), DoubleNear(-1, 1e-12)));
  EXPECT_THAT(deposit.outline, testing::Each(SizeIs(4)));
}

TEST(Deposit, OfBoxesThatTouchAtACornerHasTwoRings) {
  BlockSystem system;
  system.blocks = {box_block("one", {0, 0, 0}, {1, 1, 1}, BodyKind::rigid),
                   box_block("other", {1, 1, 0}, {1, 1, 1}, BodyKind::rigid)};
  const Deposit deposit = of(system, std::vector<Vec3>(2, Vec3(5, 5, 0)), 0.5);
  EXPECT_THAT(areas_of(deposit.outline), ElementsAre(DoubleNear(1, 1e-12), DoubleNear(1, 1e-12)));
}

TEST(Deposit, HasRoundCellsOfWhichSomeTwoHundredMakeItsLength) {
  const Deposit deposit = of(floor_and_boxes(), {{0, 0, 0}, {6, 0, -10}, {4, 0, -20}, {0, 0, 0}}, {});
  EXPECT_NEAR(deposit.grid.cell, 0.02, 1e-12) << "8 m / 200 = 0.04 m";
  EXPECT_NEAR(deposit.area, 5, 1e-9);
}

TEST(Deposit, RefusesCellsThatAreNoneOrTooMany) {
  const std::vector<Vec3> ways{{0, 0, 0}, {6, 0, -10}, {4, 0, -20}, {0, 0, 0}};
  EXPECT_THROW(of(floor_and_boxes(), ways, 0.0), InputError);
  EXPECT_THROW(of(floor_and_boxes(), ways, NAN), InputError);
  EXPECT_THROW(of(floor_and_boxes(), ways, 1e-4), InputError);
}

TEST(Deposit, OfRockThatStayedIsEmpty) {
  const Deposit deposit = of(floor_and_boxes(), at_rest);
  EXPECT_EQ(deposit.area, 0);
  EXPECT_THAT(deposit.outline, SizeIs(0));
}

}  // namespace
}  // namespace talus
