#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "mesh/block.hpp"

namespace talus {

/// The drawn surface of some blocks as one mesh: triangles, and the edges where the surface bends.
struct BlockSurface {
  std::vector<int> nodes;  ///< a vertex: its node, numbered through all blocks
  std::vector<Vec3> rest;  ///< a vertex: undeformed position, m
  struct Triangle {
    std::array<int, 3> vertices;
    int block;
    int tetrahedron;  ///< the one behind it, numbered through all blocks; −1: none has these nodes
    int facet;        ///< index into Block::surface
  };
  std::vector<Triangle> triangles;
  struct Edge {
    std::array<int, 2> vertices;
    int block;
    bool sharp;  ///< the surface bends here by more than 15° where it goes on at both ends; or by more than 40°
  };
  std::vector<Edge> edges;
  /// Where those of a block begin, which follow each other; after the last block, how many there are.
  struct Begin {
    int vertex, triangle, edge;
  };
  std::vector<Begin> begins;
};

/// Around all nodes, undeformed [m]; empty where there are none.
Eigen::AlignedBox3d bounds(const BlockSystem& system);

/// Surface of the blocks for which `wanted[block]`.
BlockSurface block_surface(const BlockSystem& system, const std::vector<bool>& wanted);

/// Pairs (i < j) of blocks whose surfaces touch over an area in the undeformed state.
std::vector<std::array<int, 2>> touching_blocks(const BlockSystem& system);

/// Index into a palette of `colour_count` for every block, so that touching blocks differ wherever that many colours
/// suffice greedily; where not, the colour that the fewest neighbours have. Colours are used evenly.
std::vector<int> colour_indices(int block_count, const std::vector<std::array<int, 2>>& touching, int colour_count);

}  // namespace talus
