#include "render/scene/block_surface.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace talus {
namespace {

/// A unit cube at `low` in twelve triangles around one inner node (index 8), one tetrahedron behind each.
Block cube(const Vec3& low, BodyKind body = BodyKind::tetrahedra) {
  Block block;
  block.body = body;
  for (int i = 0; i < 8; ++i) block.mesh.nodes.push_back(low + Vec3(i & 1 ? 1 : 0, i & 2 ? 1 : 0, i & 4 ? 1 : 0));
  block.mesh.nodes.push_back(low + Vec3(0.5, 0.5, 0.5));
  constexpr int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& q : quads)
    for (const std::array<int, 3>& t : {std::array{q[0], q[1], q[2]}, {q[0], q[2], q[3]}}) {
      block.surface.push_back({t, -1});
      block.mesh.tetrahedra.push_back({t[0], t[2], t[1], 8});
    }
  return block;
}

TEST(BlockSurface, LeavesInnerNodesOutAndNumbersThroughAllBlocks) {
  BlockSystem system;
  system.blocks = {cube({0, 0, 0}), cube({5, 0, 0})};
  const BlockSurface surface = block_surface(system, {false, true});
  EXPECT_EQ(surface.nodes.size(), 8u);
  EXPECT_EQ(surface.triangles.size(), 12u);
  for (const int node : surface.nodes) EXPECT_TRUE(node >= 9 && node < 17);
  for (std::size_t t = 0; t < 12; ++t) {
    EXPECT_EQ(surface.triangles[t].block, 1);
    EXPECT_EQ(surface.triangles[t].tetrahedron, 12 + static_cast<int>(t));
  }
}

TEST(BlockSurface, SaysWhereEachBlockBegins) {
  BlockSystem system;
  system.blocks = {cube({0, 0, 0}), cube({5, 0, 0}), cube({9, 0, 0})};
  const BlockSurface surface = block_surface(system, {true, false, true});
  ASSERT_EQ(surface.begins.size(), 4u);
  for (std::size_t block = 0; block < 3; ++block)
    for (int t = surface.begins[block].triangle; t < surface.begins[block + 1].triangle; ++t) {
      EXPECT_EQ(surface.triangles[static_cast<std::size_t>(t)].block, static_cast<int>(block));
      for (const int vertex : surface.triangles[static_cast<std::size_t>(t)].vertices)
        EXPECT_TRUE(vertex >= surface.begins[block].vertex && vertex < surface.begins[block + 1].vertex);
    }
  EXPECT_EQ(surface.begins[1].triangle, surface.begins[2].triangle) << "one that is left out has none";
  EXPECT_EQ(surface.begins[3].triangle, 24);
  EXPECT_EQ(surface.begins[3].edge, static_cast<int>(surface.edges.size()));
}

/// Rough ground of 20 × 20 points, 1 m apart, that bends by 15° here and there.
Block rough_ground() {
  constexpr int side = 20;
  Block block;
  unsigned chance = 1;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      chance = chance * 1103515245u + 12345u;
      block.mesh.nodes.emplace_back(x, y, 0.14 * static_cast<double>(chance >> 16 & 0xffff) / 0xffff);
    }
  for (int y = 0; y + 1 < side; ++y)
    for (int x = 0; x + 1 < side; ++x) {
      const int a = side * y + x;
      block.surface.push_back({{a, a + 1, a + side + 1}, -1});
      block.surface.push_back({{a, a + side + 1, a + side}, -1});
    }
  return block;
}

TEST(BlockSurface, HasNoSpecksOnRoughGround) {
  BlockSystem system;
  system.blocks = {rough_ground()};
  std::map<int, int> ends;
  int sharp_edges = 0;
  const BlockSurface surface = block_surface(system, {true});
  for (const auto& edge : surface.edges)
    if (edge.sharp) {
      ++sharp_edges;
      for (const int vertex : edge.vertices) ++ends[vertex];
    }
  EXPECT_GE(sharp_edges, 4 * 19) << "the rim";
  for (const auto& [vertex, count] : ends) EXPECT_GE(count, 2) << "a line ends at " << vertex;
}

TEST(BlockSurface, TellsSharpEdgesFromMeshLines) {
  BlockSystem system;
  system.blocks = {cube({0, 0, 0})};
  int sharp_edges = 0, flat = 0;
  for (const auto& edge : block_surface(system, {true}).edges) ++(edge.sharp ? sharp_edges : flat);
  EXPECT_EQ(sharp_edges, 12);
  EXPECT_EQ(flat, 6);
}

TEST(TouchingBlocks, ShareAnAreaAndNotJustAnEdge) {
  BlockSystem system;
  system.blocks = {cube({0, 0, 0}), cube({1, 0, 0}), cube({1, 1, 0}), cube({0.4, 0.3, 1}), cube({9, 9, 9})};
  const std::vector<std::array<int, 2>> expected{{0, 1}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  EXPECT_EQ(touching_blocks(system), expected);
}

TEST(TouchingBlocks, HoldsFarFromTheOrigin) {
  BlockSystem system;
  const Vec3 far(512307.4, 3214880.1, 1214.6);
  system.blocks = {cube(far), cube(far + Vec3(1, 0, 0)), cube(far + Vec3(2.001, 0, 0))};
  const std::vector<std::array<int, 2>> expected{{0, 1}};
  EXPECT_EQ(touching_blocks(system), expected);
}

TEST(ColourIndices, DifferBetweenNeighboursAndAreUsedEvenly) {
  std::vector<std::array<int, 2>> touching;
  const int side = 6;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      if (i + 1 < side) touching.push_back({i * side + j, (i + 1) * side + j});
      if (j + 1 < side) touching.push_back({i * side + j, i * side + j + 1});
      if (i + 1 < side && j + 1 < side) touching.push_back({i * side + j, (i + 1) * side + j + 1});
    }
  const std::vector<int> colour = colour_indices(side * side, touching, 8);
  for (const auto& [a, b] : touching) EXPECT_NE(colour[a], colour[b]);
  EXPECT_EQ(std::set<int>(colour.begin(), colour.end()).size(), 8u);
}

TEST(ColourIndices, ManageWithTooFewColours) {
  const std::vector<int> colour = colour_indices(3, {{0, 1}, {0, 2}, {1, 2}}, 2);
  for (const int c : colour) EXPECT_TRUE(c == 0 || c == 1);
  EXPECT_FALSE(colour[0] == colour[1] && colour[1] == colour[2]);
}

}  // namespace
}  // namespace talus
