#include "verification/random/node_laws.hpp"

#include <gmock/gmock.h>

#include "model/stages.hpp"
#include "verification/hard_cases/shapes.hpp"
#include "verification/hard_cases/trial.hpp"

// Each law must be able to fail: bodies that break it are told of, those that do not are not.
namespace talus {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// A body that flies freely, unless there is a wall.
CaseScene flight(BodyKind body, const Vec3& velocity, const Vec3& spin) {
  CaseScene scene = rock_scene(30);
  scene.project.gravity.setZero();
  scene.add_block("body", placed(box_mesh({-0.5, -0.3, -0.2}, {0.5, 0.3, 0.2}, 1, 1, 1), {0, 0, 2}), body);
  scene.project.velocities = {{.block = "body", .linear = velocity, .angular = spin}};
  scene.project.stages = {dynamic_stage(1e-2, 1)};
  return scene;
}

std::string fault_of(const CaseScene& scene, const HardCaseExpectation& expectation) {
  HardCase one;
  one.expected = {expectation};
  one.build = [scene] { return scene; };
  one.keeps_nodes = true;
  NoProgress progress;
  const Trial trial = run_trial(one, {}, progress);
  EXPECT_EQ(trial.ending, TrialEnding::completed) << trial.reason;
  return trial.unmet.empty() ? "" : trial.unmet.front().words;
}

TEST(NodeLaws, ABodyBehindThePlaneIsLost) {
  const CaseScene scene = flight(BodyKind::rigid, {0, 0, -1}, Vec3::Zero());
  // Its lowest node comes from 1.8 m to 0.8 m.
  EXPECT_THAT(fault_of(scene, nodes_stay_before("body", {0, 0, 0.75}, Vec3::UnitZ(), 0)), IsEmpty());
  EXPECT_THAT(fault_of(scene, nodes_stay_before("body", {0, 0, 0.85}, Vec3::UnitZ(), 0)), HasSubstr("behind it"));
  EXPECT_THAT(fault_of(scene, nodes_stay_before("body", {0, 0, 0.85}, Vec3::UnitZ(), 0.1)), IsEmpty());
}

TEST(NodeLaws, ABodyOutsideTheBoxIsLost) {
  const CaseScene scene = flight(BodyKind::rigid, {1, 0, 0}, Vec3::Zero());
  EXPECT_THAT(fault_of(scene, nodes_stay_in_box({-1, -1, 1}, {1.6, 1, 3}, 0)), IsEmpty());
  EXPECT_THAT(fault_of(scene, nodes_stay_in_box({-1, -1, 1}, {1.4, 1, 3}, 0)), HasSubstr("outside it"));
  EXPECT_THAT(fault_of(scene, nodes_stay_in_box({-1, -1, 1.9}, {1.6, 1, 3}, 0)), HasSubstr("outside it"));
}

TEST(NodeLaws, ABodyBelowTheBedIsLost) {
  const CaseScene scene = flight(BodyKind::rigid, {0, 0, -1}, Vec3::Zero());
  const auto above = [](double level) {
    return nodes_stay_above(
        "the bed", [level](const Vec3& point) { return level - point.z(); }, 0.1);
  };
  EXPECT_THAT(fault_of(scene, above(0.85)), IsEmpty());
  EXPECT_THAT(fault_of(scene, above(0.95)), HasSubstr("below the bed"));
}

TEST(NodeLaws, WhatFliesOnIsNotTurnedAway) {
  CaseScene scene = flight(BodyKind::rigid, {0, 0, -3}, Vec3::Zero());
  const HardCaseExpectation away = is_turned_away("body", Vec3::Zero(), 0.01);
  EXPECT_THAT(fault_of(scene, away), HasSubstr("it flies on"));
  scene.add_fixed_box("wall", {-5, -5, -1}, {5, 5, 0});
  EXPECT_THAT(fault_of(scene, away), IsEmpty());
}

TEST(NodeLaws, FallingFreelyIsNotToBeTurnedAway) {
  CaseScene scene = flight(BodyKind::rigid, {3, 0, 0}, Vec3::Zero());
  scene.project.gravity = {0, 0, -9.81};
  EXPECT_THAT(fault_of(scene, is_turned_away("body", scene.project.gravity, 0.01)), HasSubstr("it flies on"));
}

TEST(NodeLaws, FreeSpinOfARigidBodyKeepsMomentum) {
  const CaseScene scene = flight(BodyKind::rigid, {1, 2, 3}, {0.3, 1, 0.2});
  EXPECT_THAT(fault_of(scene, momentum_stays(scene.project.materials, 1e-9)), IsEmpty());
}

TEST(NodeLaws, FlightWithoutSpinKeepsMomentumOfEveryBody) {
  for (const BodyKind body : {BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra}) {
    CaseScene scene = flight(body, {1, 2, 3}, Vec3::Zero());
    scene.add_block("other", placed(cube(1), {0, 5, 2}), body);  // about which the first one turns
    EXPECT_THAT(fault_of(scene, momentum_stays(scene.project.materials, 1e-9)), IsEmpty()) << to_string(body);
  }
}

TEST(NodeLaws, AForceChangesMomentumAndACoupleTheAngularOne) {
  CaseScene scene = flight(BodyKind::rigid, {1, 2, 3}, {0.3, 1, 0.2});
  const HardCaseExpectation stays = momentum_stays(scene.project.materials, 1e-9);
  scene.project.loads = {{.block = "body", .at = {0.5, 0, 2}, .force = {0, 1, 0}}};
  EXPECT_THAT(fault_of(scene, stays), HasSubstr("linear momentum drifts by"));
  scene.project.loads.push_back({.block = "body", .at = {-0.5, 0, 2}, .force = {0, -1, 0}});
  EXPECT_THAT(fault_of(scene, stays), HasSubstr("angular by"));
}

}  // namespace
}  // namespace talus
