// Values of joints on their walls, held against blocks whose equilibrium and travel are known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fields/field_values.hpp"
#include "solve/simulation.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

using test::box_block;
constexpr double weight = 2600 * 9.81;  ///< N, of a unit cube

/// A cube on a slab that dips by so much, after a stage.
struct CubeOnIncline {
  CubeOnIncline(double dip, double friction_angle, Stage stage, BodyKind body, double cohesion = 0) {
    project = test::rock_project(friction_angle, {std::move(stage)});
    project.joints[0].cohesion = cohesion;
    project.gravity = test::tilted_gravity(dip);
    system = test::cube_on_slab();
    system.blocks[1].body = body;
    Simulation simulation(project, system);
    while (!simulation.finished()) simulation.step();
    EXPECT_TRUE(simulation.converged()) << simulation.failure();
    frame = simulation.frame(0);
  }

  Project project;
  BlockSystem system;
  Frame frame;
};

/// A wall's values over its area.
struct WallMean {
  double area = 0, mean = 0, low = 0, high = 0;
};

/// Over those triangles of a block's walls that have values and look down, or up.
WallMean mean_over(const BlockSystem& system, const Frame& frame, const char* field, int block, double up) {
  const FieldValues fields(system);
  const std::vector<double> values = fields.of(frame, field_named(field));
  const JointWalls& walls = fields.walls();
  EXPECT_EQ(values.size(), walls.points.size());
  std::vector<Vec3> rest;
  for (const Block& each : system.blocks) rest.insert(rest.end(), each.mesh.nodes.begin(), each.mesh.nodes.end());
  WallMean result{0, 0, 1e300, -1e300};
  for (const JointWalls::Triangle& triangle : walls.triangles) {
    const auto corners = corner_values(triangle, values);
    if (triangle.block != block || !corners) continue;
    std::array<Vec3, 3> at;
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const WallPoint& point = walls.points[static_cast<std::size_t>(triangle.points[i])];
      at[i] = SurfacePlace{point.place.nodes, point.corner}.of(rest);
      sum += (*corners)[i] / 3;
    }
    const Vec3 twice = (at[1] - at[0]).cross(at[2] - at[0]);
    if (twice.normalized().z() * up < 0.9) continue;
    result.area += twice.norm() / 2;
    result.mean += sum * twice.norm() / 2;
    result.low = std::min(result.low, sum);
    result.high = std::max(result.high, sum);
  }
  result.mean /= result.area;
  return result;
}

WallMean on_base(const CubeOnIncline& cube, const char* field) {
  return mean_over(cube.system, cube.frame, field, 1, -1);
}

constexpr BodyKind kinds[] = {BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra};

TEST(JointFields, BaseOfACubeAtRestBearsItsWeightOnBothWalls) {
  constexpr double dip = 20, slope = dip * M_PI / 180;
  for (const BodyKind kind : kinds) {
    const CubeOnIncline cube(dip, 40, {"rest", StageKind::static_, 0.01, 60, {}}, kind);
    for (const auto& [block, up] : {std::pair(1, -1.0), std::pair(0, 1.0)}) {
      const auto mean = [&](const char* field) { return mean_over(cube.system, cube.frame, field, block, up); };
      const WallMean normal = mean("joint.normal_stress");
      if (block == 1) {
        EXPECT_NEAR(normal.area, 1, 1e-9);
      } else {
        EXPECT_NEAR(normal.area, 1, 0.2) << "the triangles of so large a slab are a fifth of the cube's edge";
      }
      EXPECT_NEAR(normal.mean, weight * std::cos(slope), (block == 1 ? 0.01 : 0.05) * weight) << to_string(kind);
      EXPECT_NEAR(mean("joint.shear_stress").mean, weight * std::sin(slope), 0.02 * weight);
      EXPECT_EQ(mean("joint.state").low, static_cast<double>(WallState::sticks));
      EXPECT_EQ(mean("joint.state").high, static_cast<double>(WallState::sticks));
      EXPECT_EQ(mean("joint.bond").high, static_cast<double>(Bond::none));
      EXPECT_EQ(mean("joint.cohesion").high, 0);
    }
    EXPECT_NEAR(on_base(cube, "joint.slip").high, 0, 1e-4);
  }
}

TEST(JointFields, NormalStressOfARigidCubeIsLargerAtTheLowerEdgeAsItsMomentAsks) {
  constexpr double slope = 20 * M_PI / 180;
  const CubeOnIncline cube(20, 40, {"rest", StageKind::static_, 0.01, 60, {}}, BodyKind::rigid);
  // Two corners at the lower edge bear F, two at the upper one f: F + f = N, F − f = T, each pair over half the area.
  const WallMean stress = on_base(cube, "joint.normal_stress");
  EXPECT_NEAR(stress.high, weight * (std::cos(slope) + std::sin(slope)), 0.05 * weight);
  EXPECT_NEAR(stress.low, weight * (std::cos(slope) - std::sin(slope)), 0.05 * weight);
}

TEST(JointFields, OfACubeThatSlidesSlipIsItsTravelAndStrengthIsMobilised) {
  for (const BodyKind kind : kinds) {
    const CubeOnIncline cube(30, 15, {"slide", StageKind::dynamic, 0.005, {}, 0.6}, kind);
    const double travel = cube.frame.displacement.back().x();
    EXPECT_NEAR(travel, 9.81 * (0.5 - std::tan(M_PI / 12) * std::cos(M_PI / 6)) * 0.18, 0.005);
    for (const double slip : {on_base(cube, "joint.slip").low, on_base(cube, "joint.slip").high})
      EXPECT_NEAR(slip, travel, 1e-3 * travel) << to_string(kind);
    EXPECT_NEAR(mean_over(cube.system, cube.frame, "joint.slip", 0, 1).high, travel, 1e-3 * travel);
    EXPECT_NEAR(on_base(cube, "joint.opening").high, 0, 1e-4);
    EXPECT_EQ(on_base(cube, "joint.state").low, static_cast<double>(WallState::slides)) << to_string(kind);
    EXPECT_NEAR(on_base(cube, "joint.mobilised").mean, 1, 1e-3);
    EXPECT_NEAR(on_base(cube, "joint.shear_stress").mean, std::tan(M_PI / 12) * weight * std::cos(M_PI / 6),
                0.02 * weight);
  }
}

TEST(JointFields, ABondIsWholeBelowItsStrengthAndBrokenAbove) {
  const double shear = weight * std::sin(M_PI / 6);  // Pa, on 1 m²
  const CubeOnIncline held(30, 0, {"hold", StageKind::static_, 0.01, 30, {}}, BodyKind::rigid, 1.5 * shear);
  EXPECT_EQ(on_base(held, "joint.bond").low, static_cast<double>(Bond::whole));
  EXPECT_EQ(on_base(held, "joint.state").low, static_cast<double>(WallState::bonded));
  EXPECT_DOUBLE_EQ(on_base(held, "joint.cohesion").mean, 1.5 * shear);
  EXPECT_NEAR(on_base(held, "joint.mobilised").mean, 1 / 1.5, 0.05);
  const CubeOnIncline torn(30, 5, {"slide", StageKind::dynamic, 0.005, {}, 0.2}, BodyKind::rigid, 0.3 * shear);
  EXPECT_EQ(on_base(torn, "joint.bond").low, static_cast<double>(Bond::broken));
  EXPECT_EQ(on_base(torn, "joint.cohesion").high, 0);
}

/// The upper of two cubes, moved.
Frame moved(const BlockSystem& system, const Vec3& by) {
  Frame frame;
  for (std::size_t b = 0; b < system.blocks.size(); ++b)
    frame.displacement.resize(frame.displacement.size() + system.blocks[b].mesh.nodes.size(),
                              b == 1 ? by : Vec3(Vec3::Zero()));
  return frame;
}

TEST(JointFields, OpeningAndSlipAreToldWhereNothingTouchesAnyMore) {
  const BlockSystem system = test::cube_on_slab();
  const Frame frame = moved(system, Vec3(0.3, 0.4, 0.2));
  for (const auto& [block, up] : {std::pair(1, -1.0), std::pair(0, 1.0)}) {
    const WallMean opening = mean_over(system, frame, "joint.opening", block, up);
    EXPECT_NEAR(opening.low, 0.2, 1e-12);
    EXPECT_NEAR(opening.high, 0.2, 1e-12);
    EXPECT_NEAR(mean_over(system, frame, "joint.slip", block, up).mean, 0.5, 1e-12);
  }
  EXPECT_EQ(mean_over(system, frame, "joint.normal_stress", 1, -1).area, 0);
  EXPECT_EQ(mean_over(system, frame, "joint.slip", 1, 1).area, 0) << "nothing lay on the cube";
}

TEST(JointFields, WhatResultsOfEarlierVersionsLackIsSaid) {
  const BlockSystem system = test::cube_on_slab();
  Frame frame;
  frame.contacts.push_back({Vec3::Zero(), Vec3::UnitZ(), {1, 0}, 0, ContactState::stick, 1, Vec3::Zero(), 1});
  for (const char* name : {"joint.mobilised", "joint.bond", "joint.cohesion"})
    EXPECT_THAT(why_absent(system, frame, field_named(name)), testing::HasSubstr("earlier version")) << name;
  for (const char* name : {"joint.normal_stress", "joint.state", "joint.slip", "displacement"})
    EXPECT_EQ(why_absent(system, frame, field_named(name)), "") << name;
  frame.contacts[0].friction = 0.5;
  EXPECT_EQ(why_absent(system, frame, field_named("joint.bond")), "");
}

TEST(JointWalls, OfALargeFaceHaveManyPointsAndCoverItsArea) {
  const BlockSystem system = test::cube_on_slab();
  const JointWalls walls = joint_walls(system);
  EXPECT_GT(walls.triangles.size(), 1000u);
  EXPECT_LT(walls.triangles.size(), 200000u);
  const auto has_opposite = [](const WallPoint& point) { return point.opposite >= 0; };
  EXPECT_GT(std::ranges::count_if(walls.points, has_opposite), 20);
  for (const WallPoint& point : walls.points)
    if (has_opposite(point)) {
      EXPECT_EQ(point.opposite, 1 - point.block);
      EXPECT_NEAR(std::abs(point.normal.z()), 1, 1e-12);
    }
}

}  // namespace
}  // namespace talus
