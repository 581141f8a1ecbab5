#include "verification/hard_cases/elsewhere.hpp"

#include <gtest/gtest.h>

#include "verification/hard_cases/shapes.hpp"

namespace talus {
namespace {

const Elsewhere place{37, {3e6, 4e6, 0}};

CaseScene two_cubes() {
  CaseScene scene;
  scene.add_block("base", placed(cube(1), {1.0 / 3, 0, 0}), BodyKind::fixed);
  scene.add_block("cube", placed(cube(0.1), {1.0 / 7, 0.3, 0.55}), BodyKind::rigid);
  return scene;
}

TEST(Elsewhere, EverythingIsTurnedAndMoved) {
  CaseScene scene = two_cubes();
  scene.project.velocities = {{.block = "cube", .linear = {1, 0, 0}, .angular = {0, 1, 0}}};
  scene.project.loads = {{.block = "cube", .at = {1, 0, 0}, .force = {2, 0, 0}, .table = {{0, {3, 0, 0}}}}};
  scene.project.constraints = {{.block = "base", .at = Vec3(1, 0, 0), .table = {{0, {3, 0, 0}}}}};
  place_scene(scene, turn_about(Vec3::UnitZ(), 90), {10, 0, 0});
  const auto expect_at = [](const Vec3& vector, const Vec3& expected) {
    EXPECT_LT((vector - expected).norm(), 1e-14) << vector.transpose();
  };
  expect_at(scene.project.velocities[0].linear, {0, 1, 0});
  expect_at(scene.project.velocities[0].angular, {-1, 0, 0});
  expect_at(scene.project.loads[0].at, {10, 1, 0});
  expect_at(scene.project.loads[0].force, {0, 2, 0});
  expect_at(scene.project.loads[0].table[0].value, {0, 3, 0});
  expect_at(*scene.project.constraints[0].at, {10, 1, 0});
  expect_at(scene.project.constraints[0].table[0].value, {0, 3, 0});
}

/// The scene there is rounded to 1e-9 m; what was brought home has the same lengths to the last digits.
TEST(Elsewhere, WhatIsBroughtHomeHasTheShapesThatItHadThere) {
  const CaseScene here = two_cubes(), there = moved_elsewhere(here, place), home = brought_home(there, place);
  const Mat3 turn = turn_about(Vec3::UnitZ(), place.azimuth);
  const auto at = [](const CaseScene& scene, int block, int node) {
    return scene.system.blocks[block].mesh.nodes[node];
  };
  double rounded = 0;
  for (int node = 0; node < 8; ++node) {
    const Vec3 far = at(there, 1, node) - at(there, 0, 0), near = at(home, 1, node) - at(home, 0, 0);
    EXPECT_LT((far - turn * near).norm(), 1e-15);
    rounded = std::max(rounded, (near - (at(here, 1, node) - at(here, 0, 0))).norm());
  }
  EXPECT_GT(rounded, 1e-11);
  EXPECT_LT(rounded, 1e-8);
}

TEST(Elsewhere, TheExtentIsThatOfWhatMoves) {
  EXPECT_NEAR(extent_of_what_moves(two_cubes()), 0.1 * std::sqrt(3), 1e-15);
}

TEST(Elsewhere, DisplacementsAreComparedTurned) {
  const Elsewhere quarter{90, Vec3::Zero()};
  EXPECT_NEAR(most_apart({{1, 0, 0}, {0, 0, 2}}, {{0, 1, 0}, {0, 0, 2}}, quarter), 0, 1e-15);
  EXPECT_NEAR(most_apart({{1, 0, 0}, {0, 0, 2}}, {{0, 1, 0}, {0, 0, 2.5}}, quarter), 0.5, 1e-15);
}

}  // namespace
}  // namespace talus
