#include <cmath>
#include <cstring>

#include "rock.hpp"

namespace talus {
namespace {

using namespace rock;

bool same_bits(const BlockSystem& a, const BlockSystem& b) {
  if (a.blocks.size() != b.blocks.size()) return false;
  for (std::size_t i = 0; i < a.blocks.size(); ++i) {
    const Block &p = a.blocks[i], &q = b.blocks[i];
    if (p.name != q.name || p.mesh.tetrahedra != q.mesh.tetrahedra || p.mesh.nodes.size() != q.mesh.nodes.size()) {
      return false;
    }
    for (std::size_t k = 0; k < p.mesh.nodes.size(); ++k) {
      if (std::memcmp(p.mesh.nodes[k].data(), q.mesh.nodes[k].data(), 3 * sizeof(double)) != 0) return false;
    }
    for (std::size_t k = 0; k < p.surface.size(); ++k) {
      if (p.surface[k].nodes != q.surface[k].nodes || p.surface[k].joint != q.surface[k].joint) return false;
    }
  }
  return true;
}

Project cut_cube(const Vec3& corner) {
  Project p = project();
  p.solids = {box("cube", corner, corner + Vec3(10, 10, 10), 2)};
  p.cuts = {cut("J1", 35, 120, corner + Vec3(5, 5, 5)), cut("J2", 70, 240, corner + Vec3(4, 6, 5))};
  return p;
}

TEST(Meshing, IsTheSameEachTimeToTheLastBit) {
  EXPECT_TRUE(same_bits(build(cut_cube({0, 0, 0})), build(cut_cube({0, 0, 0}))));
}

TEST(Meshing, FarCoordinatesCostNoAccuracy) {
  const Vec3 far(1e6, -1e6, 2000);
  const BlockSystem there = build(cut_cube(far)), here = build(cut_cube({0, 0, 0}));
  ASSERT_EQ(there.blocks.size(), here.blocks.size());
  double sum = 0;
  for (std::size_t b = 0; b < there.blocks.size(); ++b) {
    EXPECT_EQ(there.blocks[b].name, here.blocks[b].name);
    EXPECT_NEAR(there.blocks[b].volume, here.blocks[b].volume, 1e-9 * here.blocks[b].volume);
    EXPECT_NEAR(surface_volume(there.blocks[b], far), here.blocks[b].volume, 1e-8 * here.blocks[b].volume);
    sum += there.blocks[b].volume;
  }
  EXPECT_NEAR(sum, 1000, 1e-6);
}

TEST(Meshing, MeshSizeIsThatOfTheBlock) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, 10)};
  EXPECT_LE(build(p).blocks[0].mesh.tetrahedra.size(), 12u);
  p.solids = {box("long", {0, 0, 0}, {130, 355, 60}, 355)};
  EXPECT_LE(build(p).blocks[0].mesh.tetrahedra.size(), 20u);
  p.solids[0].mesh_size.reset();  // a tenth of the longest side: 35.5 m
  const std::size_t fine = build(p).blocks[0].mesh.tetrahedra.size();
  EXPECT_GT(fine, 250u);
  EXPECT_LT(fine, 1000u);
  p.cuts = {cut("J1", 90, 0, {0, 200, 0})};
  p.blocks = {{"coarse", {65, 300, 30}, {}, {}, 200.0}};
  const BlockSystem system = build(p);
  EXPECT_LE(block(system, "coarse").mesh.tetrahedra.size(), 20u);
  EXPECT_GT(block(system, "long.1").mesh.tetrahedra.size(), 100u);
  expect_sound(system, 130 * 355 * 60);
}

TEST(Meshing, EdgesAreAsLongAsAskedFor) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, 1)};
  const Block b = build(p).blocks[0];
  double sum = 0;
  for (const auto& triangle : b.surface) {
    for (int k = 0; k < 3; ++k) {
      sum += (b.mesh.nodes[triangle.nodes[k]] - b.mesh.nodes[triangle.nodes[(k + 1) % 3]]).norm();
    }
  }
  EXPECT_NEAR(sum / (3 * static_cast<double>(b.surface.size())), 1, 0.15);
}

/// Distance between the extreme nodes of two blocks' facets on a joint, along the joint's normal.
double gap_on_joint(const BlockSystem& system, int joint, const Vec3& normal) {
  double lowest = 1e300, highest = -1e300;
  for (const Block& b : system.blocks) {
    for (const auto& triangle : b.surface) {
      if (triangle.joint != joint) continue;
      for (int node : triangle.nodes) {
        lowest = std::min(lowest, normal.dot(b.mesh.nodes[node]));
        highest = std::max(highest, normal.dot(b.mesh.nodes[node]));
      }
    }
  }
  return highest - lowest;
}

TEST(Meshing, NodesOnACutLieOnItToTheLastDigit) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {100, 100, 100}, 12)};
  p.cuts = {cut("J1", 30, 90, {50, 50, 50}), cut("J2", 65, 200, {40, 50, 50}), cut("J3", 80, 330, {60, 50, 50})};
  const BlockSystem system = build(p);
  const double d = std::acos(-1.0) / 180;
  EXPECT_LT(gap_on_joint(system, 0, {std::sin(30 * d), 0, std::cos(30 * d)}), 1e-15 * 200);
}

TEST(Meshing, SolidsThatTouchAlongASlantedPlaneHaveNoGap) {
  // A block on an incline of 30°, their common plane given by nothing but each one's own vertices.
  const double s = 0.5, c = std::sqrt(3.0) / 2;
  const auto at = [&](double along, double y, double up) -> Vec3 {
    return {along * c + up * s, y, -along * s + up * c};
  };
  const auto brick = [&](double from, double to, double y, double low, double high) {
    PolyhedronShape shape;
    for (double up : {low, high}) {
      for (double across : {-y, y}) {
        for (double along : {from, to}) shape.vertices.push_back(at(along, across, up));
      }
    }
    shape.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return shape;
  };
  Project p = project();
  p.solids = {solid("slope", brick(-7, 31, 9, -6, 0), 3), solid("block", brick(1, 4.3, 1.7, 0, 2), 0.7)};
  p.cuts = {cut("J2", 30, 90, {0, 0, 0})};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 2u);
  EXPECT_NEAR(joint_areas(block(system, "slope"))[1], 38 * 18, 1e-9);
  EXPECT_NEAR(joint_areas(block(system, "block"))[1], 3.3 * 3.4, 1e-9);
  EXPECT_LT(gap_on_joint(system, 1, {s, 0, c}), 1e-15 * 40);
}

TEST(Meshing, BlocksShareNoNodes) {
  const BlockSystem system = build(cut_cube({0, 0, 0}));
  ASSERT_GE(system.blocks.size(), 3u);
  for (const Block& b : system.blocks) {
    for (const auto& t : b.mesh.tetrahedra) {
      for (int node : t) ASSERT_LT(node, static_cast<int>(b.mesh.nodes.size()));
    }
    for (const auto& triangle : b.surface) {
      for (int node : triangle.nodes) ASSERT_LT(node, static_cast<int>(b.mesh.nodes.size()));
    }
  }
  expect_sound(system, 1000);
}

TEST(Meshing, AThinPlateIsMeshed) {
  Project p = project();
  p.solids = {box("plate", {0, 0, 0}, {100, 100, 100}, 20)};
  p.cuts = {cut("J1", 20, 45, {50, 50, 50}), cut("J1", 20, 45, {50, 50, 50.1})};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 3u);
  expect_sound(system, 1e6);
}

}  // namespace
}  // namespace talus
