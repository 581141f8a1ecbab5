#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "model/stages.hpp"
#include "verification/known_answers/support/recorded_run.hpp"

/// Blocks whose edges end where the other's do: they must strike each other, and rest on each other.
namespace talus {
namespace {

const std::array<double, 4> hairs = {0, 1e-12, 1e-7, 1e-4};
const std::array<Vec3, 2> places = {Vec3(0, 0, 0), Vec3(1e3, -1e3, 1e3)};

/// How far block `number` tilts that is thrown over against a wall 0.5 m away, 0.4 m wide like it [rad].
double tilt_against_a_wall(double hair, const Vec3& at) {
  CaseScene scene = rock_scene(30);
  scene.add_fixed_box("wall", at + Vec3(0.65, -0.2, 0), at + Vec3(0.8, 0.2, 1));
  scene.add_fixed_box("floor", at + Vec3(-1, -1, -0.5), at + Vec3(3, 1, 0));
  scene.add_box("falling", at + Vec3(0, -0.2 + hair, 0), at + Vec3(0.15, 0.2 + hair, 1));
  InitialVelocity thrown;
  thrown.block = "falling";
  thrown.angular = Vec3(0, 3.13, 0);
  thrown.linear = thrown.angular.cross(Vec3(-0.075, 0, 0.5));
  scene.project.velocities = {thrown};
  scene.project.stages = {dynamic_stage(0.001, 0.25)};
  NoProgress progress;
  double most = 0;
  for (const Snapshot& snapshot : record(scene, {}, progress)) most = std::max(most, snapshot.blocks[2].rotation);
  return most;
}

TEST(Coincidence, ASlabStrikesAWallOfItsOwnWidth) {
  for (const Vec3& at : places) {
    for (const double hair : hairs) {
      const double tilt = tilt_against_a_wall(hair, at);
      EXPECT_GT(tilt, 0.51) << "shifted by " << hair << " at " << at.x();
      EXPECT_LT(tilt, std::asin(0.5) + 0.005) << "shifted by " << hair << " at " << at.x();
    }
  }
}

/// A fixed prism, its ridge along y at `ridge`, 1 m long.
void add_knife_edge(CaseScene& scene, const std::string& name, const Vec3& ridge) {
  const auto corner = [&](double x, double y, double z) { return Vec3(ridge + Vec3(x, y, z)); };
  scene.add_ground(name,
                   {corner(0, 0, 0), corner(0.1, 0, -0.2), corner(-0.1, 0, -0.2), corner(0, 1, 0), corner(0.1, 1, -0.2),
                    corner(-0.1, 1, -0.2)},
                   {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {0, 3, 5}, {0, 5, 2}, {1, 2, 5}, {1, 5, 4}});
}

/// How far the last block moves in 0.1 s, in which it would fall 49 mm [m].
double sinks(CaseScene& scene) {
  scene.project.stages = {dynamic_stage(0.001, 0.1)};
  NoProgress progress;
  const std::vector<Snapshot> snapshots = record(scene, {}, progress);
  return (snapshots.back().blocks.back().displacement).norm();
}

TEST(Coincidence, ABlockRestsOnEdgesAsLongAsItIsWide) {
  for (const Vec3& at : places) {
    for (const double hair : hairs) {
      for (const double inwards : {0.0, 0.2}) {  // 0: both edges lie under the block's own
        CaseScene scene = rock_scene(30);
        add_knife_edge(scene, "left", at + Vec3(inwards, hair, 0));
        add_knife_edge(scene, "right", at + Vec3(1 - inwards, hair, 0));
        scene.add_box("block", at, at + Vec3(1, 1, 1));
        EXPECT_LT(sinks(scene), 1e-4) << "shifted by " << hair << " at " << at.x() << ", inwards " << inwards;
      }
    }
  }
}

TEST(Coincidence, EqualBoxesRestCornerOnCorner) {
  for (const Vec3& at : places) {
    for (const double hair : hairs) {
      CaseScene scene = rock_scene(30);
      scene.add_fixed_box("lower", at, at + Vec3(1, 1, 1));
      scene.add_box("middle", at + Vec3(hair, -hair, 1), at + Vec3(1 + hair, 1 - hair, 2));
      scene.add_box("upper", at + Vec3(0, 0, 2), at + Vec3(1, 1, 3));
      EXPECT_LT(sinks(scene), 1e-4) << "shifted by " << hair << " at " << at.x();
    }
  }
}

}  // namespace
}  // namespace talus
