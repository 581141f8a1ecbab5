#pragma once

#include <vector>

#include "base/vector.hpp"
#include "results/motion_class.hpp"

namespace talus {

/// A small rigid motion: what a block did in a stretch of time.
struct SmallMotion {
  Vec3 translation = Vec3::Zero();  ///< m, of the centroid
  Vec3 rotation = Vec3::Zero();     ///< rad, as a vector
  Vec3 centroid = Vec3::Zero();     ///< m, halfway

  /// Displacement of the material point that lies at `x` halfway [m].
  Vec3 at(const Vec3& x) const;
};

/// The contacts of a block with one face of another that carried force: one joint, one normal.
struct LoadedFace {
  int block = -1;                ///< the other
  int joint = -1;                ///< index into the project's joints
  Vec3 normal = Vec3::Zero();    ///< unit, towards the block
  Vec3 centre = Vec3::Zero();    ///< m, of the normal force over the window
  double impulse = 0;            ///< N·s, normal, compressive
  SmallMotion other;             ///< of the block on the other side
  bool other_can_yield = false;  ///< that block is free to move
};

/// A stretch of a block's travel: what its class is read from.
struct MotionWindow {
  SmallMotion motion;
  Mat3 spread = Mat3::Zero();  ///< m², mean of (x − c)(x − c)ᵀ over the block's volume
  Vec3 up = Vec3::UnitZ();     ///< unit, against gravity; zero without gravity
  double loaded_fraction = 0;  ///< of the time, in which a contact carried force
  std::vector<LoadedFace> faces;
};

/// What moves like this; never `stable`: whether a block moves at all is for who chooses the window.
MotionClass classify(const MotionWindow& window);

}  // namespace talus
