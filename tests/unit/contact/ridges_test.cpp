#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "blocks.hpp"

/// A ridge that has come past another by a little in both directions: which flank holds it.
namespace talus {
namespace {

using testing::box;
using testing::cells;
using testing::mapped;
using testing::Scene;

constexpr double reach = 0.01;

/// A cube whose upper right edge, along y, is met by the lower left one of another.
Scene ridge_on_ridge(double past_the_side, double below_the_top) {
  Scene scene;
  scene.add(box({-1, -1, -1}, {0, 1, 0}), true);
  scene.add(mapped(box({0, -0.5, 0}, {1, 0.5, 1}),
                   [=](const Vec3& p) { return Vec3(p - Vec3(past_the_side, 0, below_the_top)); }));
  return scene;
}

void expect_all_normals(const ContactSet& contacts, const Vec3& normal) {
  EXPECT_FALSE(contacts.points.empty());
  for (const ContactPoint& p : contacts.points) EXPECT_LT((p.normal - normal).norm(), 1e-9) << p.normal.transpose();
}

TEST(Ridges, TheFlankHasItThatTheRidgeIsLessDeepIn) {
  Scene beside = ridge_on_ridge(4e-4, 1e-3);
  expect_all_normals(beside.detect(reach), -Vec3::UnitX());
  Scene above = ridge_on_ridge(1e-3, 4e-4);
  expect_all_normals(above.detect(reach), -Vec3::UnitZ());
}

/// All points push as hard as they are deep.
void accept_as_found(Scene& scene, ContactSet contacts) {
  std::vector<ContactOutcome> outcomes;
  for (ContactPoint& p : contacts.points) {
    if (p.gap < 0) p.mode = ContactMode::stick;
    outcomes.push_back({.normal_force = std::max(0.0, -p.gap * p.normal_stiffness), .gap = p.gap});
  }
  scene.detector().accept(contacts, outcomes);
}

TEST(Ridges, WhatTheTwoPressIntoEachOtherDoesNotLetThemPass) {
  Scene scene = ridge_on_ridge(6e-4, 4e-4);
  accept_as_found(scene, scene.detect(reach));
  expect_all_normals(scene.detect(reach), -Vec3::UnitZ());
}

TEST(Ridges, WhatAThirdBodyCarriesPasses) {
  Scene scene = ridge_on_ridge(2e-4, 4e-4);
  scene.add(box({0, -1, -1}, {2, 1, 0}), true);  // flush with the first
  accept_as_found(scene, scene.detect(reach));
  EXPECT_FALSE(scene.detect(reach).points.empty());
  for (const ContactPoint& p : scene.contacts.points) EXPECT_NEAR(p.normal.x(), 0, 1e-9) << p.normal.transpose();
}

TEST(Ridges, AnEdgeDoesNotBearOnTheFlankThatItsEndHasNotComeThrough) {
  // An upright block stands on one corner, 5e-4 m below the top and 9e-3 m from the side: its upright edge passes the
  // ridge by as much.
  const Mat3 turn = Eigen::AngleAxisd(radians(-45), Vec3::UnitZ()).toRotationMatrix();
  Scene scene;
  scene.add(box({-1, -1, -1}, {0, 1, 0}), true);
  scene.add(mapped(box({0, 0, 0}, {1, 1, 1}), [&](const Vec3& p) {
    const Vec3 turned = turn * p;
    return Vec3(turned + Vec3(-9e-3, 0, 0.14 * turned.x() - 5e-4));
  }));
  expect_all_normals(scene.detect(reach), -Vec3::UnitZ());
}

TEST(Ridges, AnEdgeThatEndsInAConcaveCornerBearsBesideIt) {
  // Of three arms that meet in a corner two lie over the top, 5e-5 m apart from it, and one hangs down beside the
  // block, with its edge 1e-3 m past the side.
  const double across = std::sqrt(0.5);
  Mat3 pose;
  pose << 0, -across, -across,  //
      0, -across, across,       //
      -1, 0, 0;
  const auto solid = [](int i, int j, int k) { return i + j + k <= 1; };
  Scene scene;
  scene.add(box({-3, -3, -3}, {0, 3, 0}), true);
  scene.add(mapped(cells({2, 2, 2}, solid),
                   [&](const Vec3& p) { return Vec3(pose * (p - Vec3::Ones()) + Vec3(-1e-3, 0, 5e-5)); }));
  int at_the_ridge = 0;
  for (const ContactPoint& p : scene.detect(reach).points) {
    if ((p.normal + Vec3::UnitX()).norm() > 1e-9 || p.position.z() < -0.1) continue;
    EXPECT_NEAR(p.gap, -1e-3, 1e-9);
    ++at_the_ridge;
  }
  EXPECT_EQ(at_the_ridge, 1);
}

}  // namespace
}  // namespace talus
