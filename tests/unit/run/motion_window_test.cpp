#include "run/motion_window.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

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
  window.loaded_fraction = 1;
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

TEST(MotionWindow, SlidingOnOnePlane) {
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

TEST(MotionWindow, SlidingOnTwoPlanesGoesAlongTheirLine) {
  // The wedge of docs/validation.md: planes 40°/130° and 60°/220° meet in a line that plunges by 37.058°.
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

TEST(MotionWindow, APlaneThatTheBlockLeavesMakesNoLine) {
  // It goes down plane 1; plane 2 carried it for a while, and is 30° off the direction of sliding.
  MotionWindow window = cube(Vec3(0.05, 0, 0));
  window.faces = {face(1, Vec3(0, 0, 1), 10), face(2, Vec3(std::sin(30 * degree), std::cos(30 * degree), 0), 4)};
  EXPECT_EQ(classify(window).mode, MotionMode::sliding_on_one);
}

TEST(MotionWindow, TwoParallelPlanesAreOne) {
  MotionWindow window = cube(Vec3(0.05, 0, 0));
  window.faces = {face(1, Vec3(0, 0.05, 1), 10), face(2, Vec3(0, 0, 1), 8), face(3, Vec3(0, 0, -1), 4)};
  const MotionClass motion = classify(window);
  EXPECT_EQ(motion.mode, MotionMode::sliding_on_one);
  EXPECT_EQ(motion.joints[0], 1);
}

TEST(MotionWindow, FallingWithoutContactsOrWithFleetingOnes) {
  MotionWindow window = cube(Vec3(0, 0, -0.05));
  EXPECT_EQ(classify(window).mode, MotionMode::falling);
  window.faces = {face(1, Vec3(1, 0, 0), 10)};
  window.loaded_fraction = 0.1;
  const MotionClass motion = classify(window);
  EXPECT_EQ(motion.mode, MotionMode::falling);
  EXPECT_NEAR(attitude_of(motion.direction).plunge, 90, 1e-9);
}

TEST(MotionWindow, LandingOnAFaceIsNoSliding) {
  MotionWindow window = cube(Vec3(0.001, 0, -0.05));
  window.faces = {face(1, Vec3(0, 0, 1), 10)};
  window.loaded_fraction = 0.4;
  EXPECT_EQ(classify(window).mode, MotionMode::falling);
}

TEST(MotionWindow, TopplingAboutAnEdge) {
  const MotionClass motion = classify(over_the_edge(0.05, 0));
  EXPECT_EQ(motion.mode, MotionMode::toppling);
  EXPECT_EQ(motion.joints[0], 2);
  EXPECT_NEAR(motion.rotation_share, 1, 1e-12);
  EXPECT_NEAR(motion.axis.y(), 1, 1e-12);
  EXPECT_NEAR(attitude_of(motion.direction).trend, 90, 1e-9);
}

TEST(MotionWindow, SlidingAndTopplingShareTheTravel) {
  // Radius about the edge: √(2/12 + 1/2) = √(2/3) m.
  const MotionClass motion = classify(over_the_edge(0.05, 0.05));
  EXPECT_EQ(motion.mode, MotionMode::sliding_and_toppling);
  EXPECT_EQ(motion.joints[0], 2);
  EXPECT_NEAR(motion.rotation_share, std::sqrt(2. / 3) / (1 + std::sqrt(2. / 3)), 1e-12);
  EXPECT_EQ(classify(over_the_edge(0.05, 0.05 * 0.08)).mode, MotionMode::toppling);
  EXPECT_EQ(classify(over_the_edge(0.05 * 0.1, 0.05)).mode, MotionMode::sliding_on_one);
}

TEST(MotionWindow, TurningOnTheBaseIsTorsional) {
  MotionWindow window = cube(Vec3::Zero(), Vec3(0, 0, 0.05));
  window.faces = {face(5, Vec3::UnitZ(), 10)};
  const MotionClass motion = classify(window);
  EXPECT_EQ(motion.mode, MotionMode::torsional);
  EXPECT_EQ(motion.joints[0], 5);
  EXPECT_TRUE(motion.direction.isZero());
  window.motion.translation = Vec3(0.02, 0, 0);
  EXPECT_EQ(classify(window).mode, MotionMode::sliding_and_torsional);
}

TEST(MotionWindow, AWedgeTurningAboutTheNormalOfBothPlanesTogetherIsTorsional) {
  MotionWindow window = cube(Vec3::Zero(), Vec3(0, 0, 0.05));
  window.faces = {face(1, Vec3(0, 1, 0.6), 10), face(2, Vec3(0, -1, 0.6), 10)};
  EXPECT_EQ(classify(window).mode, MotionMode::torsional);
}

TEST(MotionWindow, WhatRidesOnAMovingBlockIsCarriedUnlessItSlidesThere) {
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

TEST(MotionWindow, WhatWeighsOnABlockIsNotWhatItSlidesOn) {
  MotionWindow window = cube(Vec3(0.05, 0, 0));
  window.faces = {face(9, -Vec3::UnitZ(), 30, Vec3(0, 0, 0.5)), face(1, Vec3::UnitZ(), 20)};
  window.faces[0].other_can_yield = true;
  EXPECT_EQ(classify(window).joints[0], 1);
}

TEST(MotionWindow, AColumnThatTopplesWithItsNeighbourIsNotCarriedByIt) {
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
