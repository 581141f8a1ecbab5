#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/vector.hpp"
#include "results/motion_class.hpp"

namespace talus {

enum class ContactState : std::uint8_t { open, stick, slip };

/// Whether a contact is held by cohesion or tension: never was, is, or was until it broke.
enum class Bond : std::uint8_t { none, whole, broken };

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
  // Not known (no number) of results that earlier versions have written.
  double friction = std::numeric_limits<double>::quiet_NaN();  ///< tan φ that holds now
  double cohesion = std::numeric_limits<double>::quiet_NaN();  ///< Pa, of a whole bond; else 0
  Bond bond = Bond::none;
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
  std::vector<char> asleep;          ///< a block: 1 where it sleeps; none where results do not tell
};

}  // namespace talus
