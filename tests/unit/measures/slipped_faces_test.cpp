#include "measures/slipped_faces.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "unit/measures/slid_boxes.hpp"

// Boxes that lie on each other, and contacts that slide or do not.
namespace talus {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

/// A floor, a box on it, and one that stands beside that box on the floor.
BlockSystem boxes_on_a_floor() {
  BlockSystem system;
  system.blocks = {box_block("floor", {0, 0, -1}, {10, 10, 1}, BodyKind::fixed),
                   box_block("box", {2, 2, 0}, {2, 2, 2}, BodyKind::rigid),
                   box_block("neighbour", {4, 2, 0}, {1, 2, 2}, BodyKind::rigid)};
  system.joint_names = {"bedding", "cross"};
  return system;
}

Frame frame_with(const BlockSystem& system, int one, int other, const Vec3& normal, ContactState state, double time) {
  Frame frame = moved_frame(system, std::vector<Vec3>(3, Vec3::Zero()), std::vector<Vec3>(3, Vec3::Zero()), time);
  frame.contacts = {{.position = Vec3::Zero(),
                     .normal = normal,
                     .blocks = {one, other},
                     .joint = 1,
                     .state = state,
                     .normal_force = 1,
                     .shear_force = Vec3::Zero(),
                     .area = 1}};
  return frame;
}

TEST(SlipWatch, FindsTheFaceOnWhichAContactSlid) {
  const BlockSystem system = boxes_on_a_floor();
  SlipWatch watch(system);
  watch.take(frame_with(system, 1, 0, Vec3::UnitZ(), ContactState::stick, 0));
  EXPECT_THAT(watch.slipped(), IsEmpty());
  watch.take(frame_with(system, 1, 0, Vec3::UnitZ(), ContactState::slip, 0.5));
  watch.take(frame_with(system, 1, 0, Vec3::UnitZ(), ContactState::slip, 0.7));
  ASSERT_THAT(watch.slipped(), SizeIs(1)) << "once, not each time";
  const SlippedFace& face = watch.slipped()[0];
  EXPECT_EQ(face.since, 0.5);
  EXPECT_EQ(face.joint, 1);
  EXPECT_NEAR(std::abs(face.normal.z()), 1, 1e-12);
  EXPECT_NEAR(face.area, 4, 1e-9);
  watch.take(frame_with(system, 2, 1, Vec3::UnitX(), ContactState::slip, 0.8));
  EXPECT_THAT(watch.slipped(), SizeIs(2));
}

TEST(SlipWatch, PassesOverContactsThatWereNoneAtRest) {
  const BlockSystem system = boxes_on_a_floor();
  SlipWatch watch(system);
  watch.take(frame_with(system, 1, 0, Vec3::UnitX(), ContactState::slip, 1));  // on another side of the box
  EXPECT_THAT(watch.slipped(), IsEmpty());
}

TEST(SlipWatch, KnowsAFaceAgainThatHasTurned) {
  const BlockSystem system = boxes_on_a_floor();
  SlipWatch watch(system);
  const Mat3 turn = Eigen::AngleAxisd(0.6, Vec3::UnitY()).toRotationMatrix();
  Frame frame = frame_with(system, 1, 2, turn * Vec3(-Vec3::UnitX()), ContactState::slip, 2);
  for (std::size_t n = 0; n < 8; ++n)
    frame.displacement[8 + n] = turn * system.blocks[1].mesh.nodes[n] - system.blocks[1].mesh.nodes[n];
  watch.take(frame);
  ASSERT_THAT(watch.slipped(), SizeIs(1));
  EXPECT_NEAR(std::abs(watch.slipped()[0].normal.x()), 1, 1e-12) << "as it was at rest";
}

}  // namespace
}  // namespace talus
