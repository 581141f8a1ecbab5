#include "measures/line_probe.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "base/error.hpp"
#include "unit/measures/slid_boxes.hpp"

// Fields that are known everywhere, along lines through boxes.
namespace talus {
namespace {

/// Of all nodes x + 2 y − z [m/s], in x.
Frame linear_velocity(const BlockSystem& system) {
  Frame frame = moved_frame(system, at_rest, at_rest);
  std::size_t n = 0;
  for (const Block& block : system.blocks)
    for (const Vec3& node : block.mesh.nodes) frame.velocity[n++] = Vec3(node.x() + 2 * node.y() - node.z(), 0, 0);
  return frame;
}

TEST(LineProbe, FollowsALinearFieldOfNodesExactly) {
  const BlockSystem system = floor_and_boxes();
  const Vec3 from(-1, 0.3, 10.2), to(4, 1.3, 10.9);  // through the slab, from x = 0 to 2
  const LineProbe probe = probe_line(system, linear_velocity(system), field_named("velocity.x"), from, to);
  const double length = (to - from).norm();
  ASSERT_FALSE(probe.pieces.empty());
  EXPECT_NEAR(probe.pieces.front().begin, length / 5, 1e-12);
  EXPECT_NEAR(probe.pieces.back().end, length * 3 / 5, 1e-12);
  double before = probe.pieces.front().begin;
  for (const LineProbe::Piece& piece : probe.pieces) {
    EXPECT_EQ(piece.block, 1);
    EXPECT_NEAR(piece.begin, before, 1e-12) << "no gap within a block";
    before = piece.end;
    for (const auto& [along, value] :
         {std::pair(piece.begin, piece.value_at_begin), std::pair(piece.end, piece.value_at_end)}) {
      const Vec3 place = from + along / length * (to - from);
      EXPECT_NEAR(value, place.x() + 2 * place.y() - place.z(), 1e-12);
    }
  }
}

TEST(LineProbe, GoesThroughBlocksWhereTheyAre) {
  const BlockSystem system = floor_and_boxes();
  const Frame frame = moved_frame(system, {still, {0, 0, -3}, still, still}, at_rest);
  const LineProbe probe = probe_line(system, frame, field_named("displacement"), {0.9, 0.8, 5}, {0.9, 0.8, -5});
  // The slab from z = 7 lies at 7 … 8: above the line's start. Only the floor, from 0 to −1, is met.
  ASSERT_FALSE(probe.pieces.empty());
  for (const LineProbe::Piece& piece : probe.pieces) EXPECT_EQ(piece.block, 0);
  EXPECT_NEAR(probe.pieces.front().begin, 5, 1e-12);
  EXPECT_NEAR(probe.pieces.back().end, 6, 1e-12);
  const LineProbe longer = probe_line(system, frame, field_named("displacement"), {0.9, 0.8, 10}, {0.9, 0.8, -5});
  EXPECT_EQ(longer.pieces.front().block, 1);
  EXPECT_NEAR(longer.pieces.front().begin, 2, 1e-12);
  EXPECT_NEAR(longer.pieces.front().value_at_begin, 3, 1e-12);
}

TEST(LineProbe, IsACurveThatBreaksOutsideOfTheRock) {
  const BlockSystem system = floor_and_boxes();
  const Frame frame = moved_frame(system, at_rest, at_rest);
  const LineProbe::Curve curve =
      probe_line(system, frame, field_named("stress.zz"), {0.9, 0.8, 20}, {0.9, 0.8, -5}).curve();
  EXPECT_THAT(curve.values, testing::Contains(testing::IsNan()).Times(1)) << "between slab and floor";
  EXPECT_NEAR(curve.along.front(), 9, 1e-12);
  EXPECT_NEAR(curve.along.back(), 21, 1e-12);
}

TEST(LineProbe, TakesTheStressOfTheTetrahedronThatItPasses) {
  const BlockSystem system = floor_and_boxes();
  Frame frame = moved_frame(system, at_rest, at_rest);
  for (std::size_t t = 0; t < frame.stress.size(); ++t) frame.stress[t][2] = t < 6 ? -1e5 : -2e5;  // floor: six
  const LineProbe probe = probe_line(system, frame, field_named("stress.zz"), {0.9, 0.8, 20}, {0.9, 0.8, -5});
  for (const LineProbe::Piece& piece : probe.pieces) EXPECT_EQ(piece.value_at_end, piece.block == 0 ? -1e5 : -2e5);
}

TEST(LineProbe, TakesWhatABlockHasAsAWholeAndNothingOfJoints) {
  const BlockSystem system = floor_and_boxes();
  const Frame frame = moved_frame(system, at_rest, at_rest);
  const Vec3 from(0.9, 0.8, 20), to(0.9, 0.8, -5);
  const LineProbe probe = probe_line(system, frame, field_named("rotation"), from, to);
  EXPECT_FALSE(probe.pieces.empty());
  for (const LineProbe::Piece& piece : probe.pieces) EXPECT_NEAR(piece.value_at_end, 0, 1e-6) << "no block has turned";
  EXPECT_THROW(probe_line(system, frame, field_named("joint.slip"), from, to), InputError);
}

TEST(LineProbe, RefusesALineWithoutLength) {
  const BlockSystem system = floor_and_boxes();
  const Frame frame = moved_frame(system, at_rest, at_rest);
  EXPECT_THROW(probe_line(system, frame, field_named("velocity"), {1, 2, 3}, {1, 2, 3}), InputError);
  EXPECT_THROW(probe_line(system, frame, field_named("velocity"), {1, 2, 3}, {NAN, 2, 3}), InputError);
  EXPECT_TRUE(probe_line(system, frame, field_named("velocity"), {0, 0, 50}, {1, 0, 50}).pieces.empty());
}

TEST(LineProbe, IsATable) {
  const BlockSystem system = floor_and_boxes();
  LineProbe probe;
  probe.pieces = {{1, 0, 2, 5, 7}};
  EXPECT_EQ(probe_csv(probe, system, field_named("velocity.x"), {1, 0, 0}, {1, 4, 0}),
            "distance [m],x [m],y [m],z [m],block,velocity.x [m/s]\n0,1,0,0,slab,5\n2,1,2,0,slab,7\n");
}

}  // namespace
}  // namespace talus
