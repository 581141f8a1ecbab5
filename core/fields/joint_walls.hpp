#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "base/vector.hpp"

namespace talus {

struct BlockSystem;

/// A place of a block's surface that goes with it, from the corners of a surface triangle.
struct SurfacePlace {
  std::array<int, 3> nodes{};    ///< numbered through all blocks
  Vec3 weights = Vec3::UnitX();  ///< their sum is 1

  /// Of a vector at all nodes.
  Vec3 of(std::span<const Vec3> nodal) const {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 3; ++i) sum += weights[i] * nodal[static_cast<std::size_t>(nodes[static_cast<std::size_t>(i)])];
    return sum;
  }
};

/// A point at which values of joints are told.
struct WallPoint {
  int block = 0;
  SurfacePlace place;           ///< a little inside its triangle: there it is told which face lies against it
  Vec3 corner = Vec3::UnitX();  ///< weights of the same nodes, where the point is drawn
  Vec3 normal = Vec3::UnitZ();  ///< unit, outwards, at rest
  int opposite = -1;            ///< the block that lay against it at the start; −1: none
  SurfacePlace across;          ///< the place of that one which it touched
};

/// The walls of joints: the surfaces of all blocks, on which values of joints are drawn, in triangles that are small
/// beside the model, so that a value may change within a face of a rigid block.
struct JointWalls {
  struct Triangle {
    std::array<int, 3> points;  ///< counter-clockwise from outside
    int block;
    int facet;  ///< index into Block::surface
  };
  std::vector<WallPoint> points;  ///< block by block
  std::vector<Triangle> triangles;
};

/// What a triangle is drawn with, of `values` of all points: where two of its corners have one, the third has their
/// mean if it has none; empty where fewer have. So the edge of what has values runs about where it is.
std::optional<std::array<double, 3>> corner_values(const JointWalls::Triangle& triangle,
                                                   std::span<const double> values);

/// Of all blocks at rest.
JointWalls joint_walls(const BlockSystem& system);

}  // namespace talus
