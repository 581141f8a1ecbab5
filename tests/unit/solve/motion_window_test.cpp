#include "solve/motion_window.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/line_attitude.hpp"

namespace talus {
namespace {

constexpr double degree = M_PI / 180;

/// A cube of 1 m at the origin that has moved by `translation` and turned by `rotation`.
MotionWindow cube(const Vec3& translation, const Vec3& rotation = Vec3::Zero()) {
  MotionWindow window;
  window.motion = {translation, rotation, Vec3::Zero()};
  window.spread = Mat3::Identity() / 12;
  window.loaded_share = 1;
  return window;
}

LoadedFace face(int joint, const Vec3& normal, double impulse, const Vec3& centre = Vec3(0, 0, -0.5)) {
  LoadedFace face;
  face.block = 0;
  face.joint = joint;
  face.normal = normal.normalized();
  face.impulse = impulse;
  face.centre = centre;
  return face;
}

/// A cube turned by `angle` about the horizontal edge x = 0.5, z = −0.5 of its base, that has slid by `slid` besides.
MotionWindow over_the_edge(double angle, double slid) {
  const Vec3 rotation(0, angle, 0);
  MotionWindow window = cube(rotation.cross(Vec3(-0.5, 0, 0.5)) + Vec3(slid, 0, 0), rotation);
  window.faces = {face(2, Vec3::UnitZ(), 10, Vec3(0.5, 0, -0.5))};
  return window;
}

TEST(MotionWindow, sliding_on_one_plane) {
  const Vec3 down_dip = Vec3(std::cos(35 * degree), 0, -std::sin(35 * degree));
  MotionWindow window = cube(0.05 * down_dip, Vec3(1e-4, 2e-4, 0));
  window.faces = {face(3, Vec3(std::sin(35 * degree), 0, std::cos(35 * degree)), 10),
                  face(4, Vec3(0, 1, 0), 0.3)};  // brushed against
  const MotionClass motion = classify(window);
  EXPECT_EQ(motion.mode, MotionMode::sliding_on_one);
  EXPECT_EQ(motion.joints, (std::array{3, -1}));
  EXPECT_EQ(motion.against, (std::array{0, -1}));
  EXPECT_NEAR(attitude_of(motion.direction).trend, 90, 1e-9);
  EXPECT_NEAR(attitude_of(motion.direction).plunge, 35, 1e-9);
  EXPECT_TRUE(motion.line.isZero());
}

TEST(MotionWindow, sliding_on_two_planes_goes_along_their_line) {
  // The wedge of METHOD §7: planes 40°/130° and 60°/220° meet in a line that plunges by 37.058°.
  const auto upward = [](double dip, double direction) {
    return Vec3(std::sin(dip * degree) * std::sin(direction * degree),
                std::sin(dip * degree) * std::cos(direction * degree), std::cos(dip * degree));
  };
  const Vec3 a = upward(40, 130), b = upward(60, 220);
  Vec3 line = a.cross(b).normalized();
  if (line.z() > 0) line = -line;
  MotionWindow window = cube(0.05 * line);
  window.faces = {face(7, b, 20), face(1, a, 15)};
  const MotionClass motion = classify(window);
  EXPECT_EQ(motion.mode, MotionMode::sliding_on_two);
  EXPECT_EQ(motion.joints, (std::array{1, 7}));
  EXPECT_NEAR(attitude_of(motion.line).plunge, 37.058, 1e-3);
  EXPECT_GT(motion.line.dot(motion.direction), 1 - 1e-12);
  EXPECT_NEAR(motion.rotation_share, 0, 1e-12);
}

TEST(MotionWindow, a_plane_that_the_block_leaves_makes_no_line) {
  // It goes down plane 1; plane 2 carried it for a while, and is 30° off the way.
  MotionWindow window = cube(Vec3(0.05, 0, 0));
  window.faces = {face(1, Vec3(0, 0, 1), 10), face(2, Vec3(std::sin(30 * degree), std::cos(30 * degree), 0), 4)};
  EXPECT_EQ(classify(window).mode, MotionMode::sliding_on_one);
}

TEST(MotionWindow, two_parallel_planes_are_one) {
  MotionWindow window = cube(Vec3(0.05, 0, 0));
  window.faces = {face(1, Vec3(0, 0.05, 1), 10), face(2, Vec3(0, 0, 1), 8), face(3, Vec3(0, 0, -1), 4)};
  const MotionClass motion = classify(window);
  EXPECT_EQ(motion.mode, MotionMode::sliding_on_one);
  EXPECT_EQ(motion.joints[0], 1);
}

TEST(MotionWindow, falling_without_contacts_or_with_fleeting_ones) {
  MotionWindow window = cube(Vec3(0, 0, -0.05));
  EXPECT_EQ(classify(window).mode, MotionMode::falling);
  window.faces = {face(1, Vec3(1, 0, 0), 10)};
  window.loaded_share = 0.1;
  const MotionClass motion = classify(window);
  EXPECT_EQ(motion.mode, MotionMode::falling);
  EXPECT_NEAR(attitude_of(motion.direction).plunge, 90, 1e-9);
}

TEST(MotionWindow, landing_on_a_face_is_no_sliding) {
  MotionWindow window = cube(Vec3(0.001, 0, -0.05));
  window.faces = {face(1, Vec3(0, 0, 1), 10)};
  window.loaded_share = 0.4;
  EXPECT_EQ(classify(window).mode, MotionMode::falling);
}

TEST(MotionWindow, toppling_about_an_edge) {
  const MotionClass motion = classify(over_the_edge(0.05, 0));
  EXPECT_EQ(motion.mode, MotionMode::toppling);
  EXPECT_EQ(motion.joints[0], 2);
  EXPECT_NEAR(motion.rotation_share, 1, 1e-12);
  EXPECT_NEAR(motion.axis.y(), 1, 1e-12);
  EXPECT_NEAR(attitude_of(motion.direction).trend, 90, 1e-9);
}

TEST(MotionWindow, sliding_and_toppling_share_the_travel) {
  // Radius about the edge: √(2/12 + 1/2) = √(2/3) m.
  const MotionClass motion = classify(over_the_edge(0.05, 0.05));
  EXPECT_EQ(motion.mode, MotionMode::sliding_and_toppling);
  EXPECT_EQ(motion.joints[0], 2);
  EXPECT_NEAR(motion.rotation_share, std::sqrt(2. / 3) / (1 + std::sqrt(2. / 3)), 1e-12);
  EXPECT_EQ(classify(over_the_edge(0.05, 0.05 * 0.08)).mode, MotionMode::toppling);
  EXPECT_EQ(classify(over_the_edge(0.05 * 0.1, 0.05)).mode, MotionMode::sliding_on_one);
}

TEST(MotionWindow, turning_on_the_base_is_torsional) {
  MotionWindow window = cube(Vec3::Zero(), Vec3(0, 0, 0.05));
  window.faces = {face(5, Vec3::UnitZ(), 10)};
  const MotionClass motion = classify(window);
  EXPECT_EQ(motion.mode, MotionMode::torsional);
  EXPECT_EQ(motion.joints[0], 5);
  EXPECT_TRUE(motion.direction.isZero());
  window.motion.translation = Vec3(0.02, 0, 0);
  EXPECT_EQ(classify(window).mode, MotionMode::sliding_and_torsional);
}

TEST(MotionWindow, a_wedge_turning_about_the_normal_of_both_planes_together_is_torsional) {
  MotionWindow window = cube(Vec3::Zero(), Vec3(0, 0, 0.05));
  window.faces = {face(1, Vec3(0, 1, 0.6), 10), face(2, Vec3(0, -1, 0.6), 10)};
  EXPECT_EQ(classify(window).mode, MotionMode::torsional);
}

TEST(MotionWindow, what_rides_on_a_moving_block_is_carried_unless_it_slides_there) {
  MotionWindow window = cube(Vec3(0.05, 0, -0.02));
  window.faces = {face(1, Vec3::UnitZ(), 10)};
  window.faces[0].block = 4;
  window.faces[0].other.translation = window.motion.translation;
  window.faces[0].other_can_yield = true;
  MotionClass motion = classify(window);
  EXPECT_EQ(motion.mode, MotionMode::carried);
  EXPECT_EQ(motion.against[0], 4);
  window.faces[0].other.translation = Vec3(0.01, 0, -0.02);
  motion = classify(window);
  EXPECT_EQ(motion.mode, MotionMode::sliding_on_one);
  EXPECT_EQ(motion.against[0], 4);
}

TEST(MotionWindow, what_weighs_on_a_block_is_not_what_it_slides_on) {
  MotionWindow window = cube(Vec3(0.05, 0, 0));
  window.faces = {face(9, -Vec3::UnitZ(), 30, Vec3(0, 0, 0.5)), face(1, Vec3::UnitZ(), 20)};
  window.faces[0].other_can_yield = true;
  EXPECT_EQ(classify(window).joints[0], 1);
}

TEST(MotionWindow, a_column_that_topples_with_its_neighbour_is_not_carried_by_it) {
  MotionWindow window = over_the_edge(0.05, 0);
  window.faces.push_back(face(3, Vec3(-1, 0, 0), 20, Vec3(0.5, 0, 0.4)));
  window.faces[1].block = 6;
  window.faces[1].other_can_yield = true;
  window.faces[1].other = window.motion;
  window.faces[1].other.centroid = Vec3(1, 0, 0);
  window.faces[1].other.translation = window.motion.rotation.cross(Vec3(-0.5, 0, 0.5));
  EXPECT_EQ(classify(window).mode, MotionMode::toppling);
}

}  // namespace
}  // namespace talus
