// Rotation, strain, and the classes of blocks, of motions that are known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/units.hpp"
#include "fields/field_values.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

/// The cube on its slab, its points moved by x → F x + b.
Frame mapped(const BlockSystem& system, const Mat3& gradient, const Vec3& by) {
  Frame frame;
  for (std::size_t b = 0; b < system.blocks.size(); ++b)
    for (const Vec3& node : system.blocks[b].mesh.nodes)
      frame.displacement.push_back(b == 1 ? Vec3(gradient * node + by - node) : Vec3(Vec3::Zero()));
  return frame;
}

std::vector<double> values_of(const Frame& frame, const char* field) {
  const BlockSystem system = test::cube_on_slab();
  return FieldValues(system).of(frame, field_named(field));
}

const Mat3 turned = Eigen::AngleAxisd(radians(110), Vec3(1, 2, 3).normalized()).toRotationMatrix();

TEST(BlockFields, RotationIsTheAngleOfTheBlock) {
  const Frame frame = mapped(test::cube_on_slab(), turned, Vec3(3, 0, 1));
  const std::vector<double> angles = values_of(frame, "rotation");
  ASSERT_EQ(angles.size(), 2u);
  EXPECT_EQ(angles[0], 0);
  EXPECT_NEAR(angles[1], 110, 1e-9);
  EXPECT_EQ(field_named("rotation").place(), FieldPlace::block);
}

TEST(BlockFields, StrainLeavesTurningOut) {
  const Frame frame = mapped(test::cube_on_slab(), turned, Vec3(3, 0, 1));
  for (const char* field : {"strain.volumetric", "strain.max_principal", "strain.min_principal", "strain.max_shear"})
    for (const double value : values_of(frame, field)) EXPECT_EQ(value, 0) << field;
}

TEST(BlockFields, StrainOfAnExtensionIsGreensAndLagranges) {
  const Mat3 extended = turned * Vec3(1.1, 1, 0.8).asDiagonal();
  const Frame frame = mapped(test::cube_on_slab(), extended, Vec3::Zero());
  const auto of_cube = [&](const char* field) { return values_of(frame, field).back(); };
  EXPECT_NEAR(of_cube("strain.max_principal"), 0.5 * (1.21 - 1), 1e-12);
  EXPECT_NEAR(of_cube("strain.min_principal"), 0.5 * (0.64 - 1), 1e-12);
  EXPECT_NEAR(of_cube("strain.max_shear"), 0.5 * (1.21 - 0.64), 1e-12);
  EXPECT_NEAR(of_cube("strain.volumetric"), 0.88 - 1, 1e-12);
  EXPECT_EQ(values_of(frame, "strain.volumetric").size(), 12u);
}

TEST(BlockFields, SleepIsToldWhereItIsRecorded) {
  const BlockSystem system = test::cube_on_slab();
  Frame frame = mapped(system, turned, Vec3::Zero());
  EXPECT_THAT(why_absent(system, frame, field_named("asleep")), testing::HasSubstr("not recorded"));
  EXPECT_THAT(values_of(frame, "asleep"), testing::Each(testing::IsNan()));
  frame.asleep = {0, 1};
  EXPECT_EQ(why_absent(system, frame, field_named("asleep")), "");
  EXPECT_THAT(values_of(frame, "asleep"),
              testing::ElementsAre(static_cast<double>(SleepState::fixed), static_cast<double>(SleepState::asleep)));
  frame.asleep = {0, 0};
  EXPECT_EQ(values_of(frame, "asleep")[1], static_cast<double>(SleepState::awake));
}

TEST(BlockFields, ClassesAreThoseOfBodiesAndMotions) {
  const BlockSystem system = test::cube_on_slab();
  Frame frame = mapped(test::cube_on_slab(), turned, Vec3::Zero());
  EXPECT_THAT(values_of(frame, "body"),
              testing::ElementsAre(static_cast<double>(BodyKind::fixed), static_cast<double>(BodyKind::tetrahedra)));
  EXPECT_THAT(why_absent(system, frame, field_named("motion")), testing::HasSubstr("not noted"));
  frame.motions.resize(2);
  frame.motions[1].mode = MotionMode::toppling;
  EXPECT_EQ(why_absent(system, frame, field_named("motion")), "");
  EXPECT_THAT(values_of(frame, "motion"),
              testing::ElementsAre(static_cast<double>(MotionMode::stable), static_cast<double>(MotionMode::toppling)));
}

}  // namespace
}  // namespace talus
