// Axes about which blocks turn, of motions that are known.
#include "measures/turning_axes.hpp"

#include <gtest/gtest.h>

#include "unit/measures/slid_boxes.hpp"

namespace talus {
namespace {

/// The boxes at rest, each going as v + ω × (x − about).
Frame turning(const BlockSystem& system, int block, const Vec3& rate, const Vec3& about) {
  Frame frame = moved_frame(system, at_rest, at_rest);
  std::size_t node = 0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b)
    for (const Vec3& place : system.blocks[b].mesh.nodes) {
      if (static_cast<int>(b) == block) frame.velocity[node] = rate.cross(place - about);
      ++node;
    }
  return frame;
}

TEST(TurningAxes, OfATopplingTowerIsItsEdge) {
  const BlockSystem system = floor_and_boxes();
  const Vec3 edge(-3, 0.5, 20), rate(0, 0.4, 0);  // the lower edge to the east
  const auto axes = turning_axes(system, turning(system, 2, rate, edge));
  ASSERT_EQ(axes.size(), 1u);
  EXPECT_EQ(axes[0].block, 2);
  EXPECT_NEAR(axes[0].rate, 0.4, 1e-12);
  EXPECT_NEAR((axes[0].direction - Vec3::UnitY()).norm(), 0, 1e-12);
  EXPECT_NEAR((axes[0].point - edge).norm(), 0, 1e-9);
  EXPECT_NEAR(axes[0].size, Vec3(0.5, 0.5, 1.5).norm(), 1e-12);
}

TEST(TurningAxes, AreNotOfBlocksThatMainlySlide) {
  const BlockSystem system = floor_and_boxes();
  const Vec3 rate(0, 0, 0.1);
  EXPECT_EQ(turning_axes(system, turning(system, 1, rate, Vec3(3, 1, 10))).size(), 1u);
  EXPECT_TRUE(turning_axes(system, turning(system, 1, rate, Vec3(30, 1, 10))).empty());
}

TEST(TurningAxes, AreNotOfBlocksThatStandStill) {
  const BlockSystem system = floor_and_boxes();
  Frame frame = turning(system, 1, Vec3(0, 0, 0.1), Vec3(1, 1, 10));
  frame.asleep = {0, 1, 0, 0};
  EXPECT_TRUE(turning_axes(system, frame).empty());
  frame.asleep = {0, 0, 1, 1};
  EXPECT_EQ(turning_axes(system, frame).size(), 1u);
  frame.motions.resize(4);
  EXPECT_TRUE(turning_axes(system, frame).empty()) << "stable";
  frame.motions[1].mode = MotionMode::torsional;
  EXPECT_EQ(turning_axes(system, frame).size(), 1u);
  frame.motions[1].came_to_rest = true;
  EXPECT_TRUE(turning_axes(system, frame).empty());
  EXPECT_TRUE(turning_axes(system, turning(system, 1, Vec3(0, 0, 5e-7), Vec3(1, 1, 10))).empty()) << "rounding";
}

}  // namespace
}  // namespace talus
