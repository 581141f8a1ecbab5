#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <set>

#include "base/error.hpp"
#include "geometry/block_builder.hpp"

namespace talus::rock {

/// A valid project without solids: one material, joints J1, J2, J3.
inline Project project() {
  Project project;
  project.name = "test";
  project.materials = {{"rock", 2600, 25e9, 0.24}};
  for (const char* name : {"J1", "J2", "J3"}) {
    Joint joint;
    joint.name = name;
    joint.friction_angle = 30;
    project.joints.push_back(joint);
  }
  project.default_joint = "J1";
  Stage stage;
  stage.name = "fall";
  stage.time_step = 0.01;
  stage.steps = 1;
  project.stages = {stage};
  return project;
}

inline Solid solid(const std::string& name, SolidShape shape, std::optional<double> mesh_size = {}) {
  Solid made;
  made.name = name;
  made.shape = std::move(shape);
  made.material = "rock";
  made.mesh_size = mesh_size;
  return made;
}

inline Solid box(const std::string& name, const Vec3& low, const Vec3& high, std::optional<double> mesh_size = {}) {
  return solid(name, BoxShape{low, high}, mesh_size);
}

inline Cut cut(const std::string& joint, double dip, double dip_direction, const Vec3& through) {
  Cut made;
  made.joint = joint;
  made.dip = dip;
  made.dip_direction = dip_direction;
  made.through = through;
  return made;
}

inline Cut joint_set(const std::string& joint, double dip, double dip_direction, const Vec3& through, double spacing,
                     int count) {
  Cut made = cut(joint, dip, dip_direction, through);
  made.spacing = spacing;
  made.count = count;
  return made;
}

inline BlockSystem build(const Project& project, const std::filesystem::path& folder = ".") {
  NoProgress nobody;
  return build_blocks(project, folder, nobody);
}

/// The message of the InputError, or what happened instead.
inline std::string error_of(const Project& project, const std::filesystem::path& folder = ".") {
  try {
    build(project, folder);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

inline double mesh_volume(const Block& block) {
  double sum = 0;
  for (const auto& t : block.mesh.tetrahedra) {
    const auto& n = block.mesh.nodes;
    sum += (n[t[1]] - n[t[0]]).cross(n[t[2]] - n[t[0]]).dot(n[t[3]] - n[t[0]]) / 6;
  }
  return sum;
}

/// By the divergence theorem about `origin`: right only when the triangles are closed and run outwards.
inline double surface_volume(const Block& block, const Vec3& origin) {
  double sum = 0;
  for (const auto& triangle : block.surface) {
    const auto at = [&](int k) -> Vec3 { return block.mesh.nodes[triangle.nodes[k]] - origin; };
    sum += at(0).dot(at(1).cross(at(2))) / 6;
  }
  return sum;
}

/// What every mesh must be: positive tetrahedra, an outward surface, volumes that add up within 1e-9.
inline void expect_sound(const BlockSystem& system, double volume) {
  double sum = 0;
  for (const Block& block : system.blocks) {
    SCOPED_TRACE(block.name);
    sum += block.volume;
    const auto& n = block.mesh.nodes;
    std::set<int> used;
    for (const auto& t : block.mesh.tetrahedra) {
      EXPECT_GT((n[t[1]] - n[t[0]]).cross(n[t[2]] - n[t[0]]).dot(n[t[3]] - n[t[0]]), 0);
      used.insert(t.begin(), t.end());
    }
    EXPECT_EQ(used.size(), n.size());
    EXPECT_NEAR(mesh_volume(block), block.volume, 1e-9 * block.volume);
    EXPECT_NEAR(surface_volume(block, n.front()), block.volume, 1e-9 * block.volume);
  }
  EXPECT_NEAR(sum, volume, 1e-9 * volume);
  EXPECT_NEAR(system.solids_volume, volume, 1e-9 * volume);
}

inline const Block& block(const BlockSystem& system, const std::string& name) {
  for (const Block& candidate : system.blocks) {
    if (candidate.name == name) return candidate;
  }
  throw std::out_of_range("no block " + name);
}

/// m² of the block's surface on each joint (−1: on none).
inline std::map<int, double> joint_areas(const Block& block) {
  std::map<int, double> areas;
  for (const auto& triangle : block.surface) {
    const auto& n = block.mesh.nodes;
    areas[triangle.joint] +=
        (n[triangle.nodes[1]] - n[triangle.nodes[0]]).cross(n[triangle.nodes[2]] - n[triangle.nodes[0]]).norm() / 2;
  }
  return areas;
}

/// A bench slope extruded along y: profile in x–z, not convex.
inline PolyhedronShape bench_slope(double length) {
  const std::vector<std::array<double, 2>> profile{{0, 0},   {100, 0}, {100, 30}, {75, 30},  {65, 55},
                                                   {50, 55}, {40, 80}, {25, 80},  {15, 100}, {0, 100}};
  const int count = static_cast<int>(profile.size());
  PolyhedronShape shape;
  for (double y : {0.0, length}) {
    for (const auto& [x, z] : profile) shape.vertices.emplace_back(x, y, z);
  }
  std::vector<int> front, back;
  for (int k = 0; k < count; ++k) {
    front.push_back(k);
    back.push_back(2 * count - 1 - k);
    const int next = (k + 1) % count;
    shape.faces.push_back({k, count + k, count + next, next});
  }
  shape.faces.push_back(front);
  shape.faces.push_back(back);
  return shape;
}
constexpr double bench_slope_area = 100 * 30 + 25 * (75 + 65) / 2.0 + 25 * (50 + 40) / 2.0 + 20 * (25 + 15) / 2.0;

}  // namespace talus::rock
