#pragma once

#include <string>
#include <vector>

#include "mesh/block.hpp"
#include "mesh/structured_mesh.hpp"
#include "results/frame.hpp"

namespace talus {

/// A box of so many metres a side with its lowest corner there, meshed from its corners.
inline Block box_block(const std::string& name, const Vec3& corner, const Vec3& sides, BodyKind body) {
  Block block;
  block.name = name;
  block.body = body;
  block.mesh = box_mesh(corner, corner + sides, 1, 1, 1);
  block.surface = boundary(block.mesh);
  block.volume = sides.prod();
  return block;
}

/// A floor of 40 m by 20 m whose top is at 0, two boxes of 2 m × 2 m × 1 m and 1 m × 1 m × 3 m high above it, and one
/// that stays where it is.
inline BlockSystem floor_and_boxes() {
  BlockSystem system;
  system.blocks = {box_block("floor", {-20, -10, -1}, {40, 20, 1}, BodyKind::fixed),
                   box_block("slab", {0, 0, 10}, {2, 2, 1}, BodyKind::rigid),
                   box_block("tower", {-4, 0, 20}, {1, 1, 3}, BodyKind::rigid),
                   box_block("lazy", {10, 0, 0}, {1, 1, 1}, BodyKind::rigid)};
  return system;
}

inline const Vec3 still = Vec3::Zero();
/// Of its blocks.
inline const std::vector<Vec3> at_rest(4, Vec3::Zero());

/// Each block moved by a vector and going at a velocity.
inline Frame moved_frame(const BlockSystem& system, const std::vector<Vec3>& displacements,
                         const std::vector<Vec3>& velocities, double time = 0) {
  Frame frame;
  frame.time = time;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const std::size_t nodes = system.blocks[b].mesh.nodes.size();
    frame.displacement.insert(frame.displacement.end(), nodes, displacements[b]);
    frame.velocity.insert(frame.velocity.end(), nodes, velocities[b]);
    frame.stress.insert(frame.stress.end(), system.blocks[b].mesh.tetrahedra.size(), Voigt::Zero());
  }
  return frame;
}

}  // namespace talus
