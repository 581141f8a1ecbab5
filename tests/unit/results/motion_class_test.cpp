#include "results/motion_class.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "example_results.hpp"

namespace talus {
namespace {

MotionClass two_planes() {
  MotionClass motion;
  motion.mode = MotionMode::sliding_on_two;
  motion.joints = {0, 1};
  motion.against = {0, 0};
  motion.line = Vec3(1, 0, -1).normalized();
  return motion;
}

TEST(MotionClass, IsToldWithJointsTheBlocksBehindThemAndTheLine) {
  EXPECT_EQ(motion_text(two_planes(), motion_names(example_system())), "sliding on J1 (B1) and J2 (B1) along 090°/45°");
  MotionClass motion;
  EXPECT_EQ(motion_text(motion, motion_names(example_system())), "stable");
  motion.mode = MotionMode::toppling;
  motion.joints = {1, -1};
  motion.against = {0, -1};
  motion.came_to_rest = true;
  EXPECT_EQ(motion_text(motion, motion_names(example_system())), "toppling on J2 (B1), came to rest");
  motion.mode = MotionMode::carried;
  EXPECT_EQ(motion_text(motion, motion_names(example_system())), "carried by B1, came to rest");
}

TEST(MotionClass, WithoutJointsTheBlockAloneIsNamed) {
  BlockSystem system = example_system();
  system.joint_names.clear();
  MotionClass motion = two_planes();
  motion.mode = MotionMode::sliding_and_toppling;
  EXPECT_EQ(motion_text(motion, motion_names(system)), "sliding on B1 and toppling");
}

TEST(MotionClass, AsJsonHasNamesAndAnglesAndNullForWhatTheModeDoesNotHave) {
  MotionClass motion = two_planes();
  motion.direction = Vec3(0, -1, 0);
  const auto json = nlohmann::json::parse(motion_json(motion, motion_names(example_system())));
  EXPECT_EQ(json["mode"], "sliding on two planes");
  EXPECT_EQ(json["joints"], nlohmann::json({"J1", "J2"}));
  EXPECT_EQ(json["against"], nlohmann::json({"B1", "B1"}));
  EXPECT_EQ(json["trend"], 180.0);
  EXPECT_EQ(json["plunge"], 0.0);
  EXPECT_NEAR(json["line"]["plunge"], 45, 1e-12);
  EXPECT_TRUE(json["axis"].is_null());
  EXPECT_FALSE(json["came_to_rest"]);
  const auto stable = nlohmann::json::parse(motion_json({}, {}));
  EXPECT_EQ(stable["mode"], "stable");
  EXPECT_TRUE(stable["trend"].is_null());
  EXPECT_TRUE(stable["joints"].empty());
}

TEST(MotionClass, ADirectionIsTrendAndPlungeInWholeDegrees) {
  EXPECT_EQ(attitude_text(Vec3(1, 0, 0)), "090°/0°");
  EXPECT_EQ(attitude_text(Vec3(-1e-4, 1, 1e-4)), "000°/0°");
  EXPECT_EQ(attitude_text(Vec3(0, 0, -1)), "000°/90°");
  EXPECT_EQ(attitude_text(Vec3::Zero()), "");
}

TEST(MotionClass, KindsAreTheSameWhateverTheDirection) {
  MotionClass other = two_planes();
  other.direction = Vec3::UnitX();
  EXPECT_TRUE(same_kind(two_planes(), other));
  other.joints[1] = 0;
  EXPECT_FALSE(same_kind(two_planes(), other));
}

}  // namespace
}  // namespace talus
