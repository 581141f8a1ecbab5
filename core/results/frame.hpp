#pragma once

#include <cstdint>
#include <vector>

#include "base/vector.hpp"
#include "results/motion_class.hpp"

namespace talus {

enum class ContactState : std::uint8_t { open, stick, slip };

/// One contact point of a frame, for drawing and for export.
struct ContactSample {
  Vec3 position;  ///< m
  Vec3 normal;    ///< unit, from the second block to the first
  int blocks[2];
  int joint;
  ContactState state;
  double normal_force;  ///< N, positive in compression
  Vec3 shear_force;     ///< N, on the first block
  double area;          ///< m²; 0 for points without an area of their own
};

/// What is known at one moment. Nodes and tetrahedra run through the blocks in BlockSystem's order.
struct Frame {
  int index = 0;
  double time = 0;                 ///< s
  int stage = 0;                   ///< index into Project::stages
  std::vector<Vec3> displacement;  ///< m, a node, since the start
  std::vector<Vec3> velocity;      ///< m/s, a node
  std::vector<Voigt> stress;       ///< Pa, a tetrahedron, tension positive
  std::vector<ContactSample> contacts;
  std::vector<MotionClass> motions;  ///< a block; none where nobody watched
};

}  // namespace talus
