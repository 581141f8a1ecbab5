#pragma once

#include <cstdint>

#include "results/hdf5.hpp"
#include "results/motion_class.hpp"

namespace talus {

/// A block's class of motion as a row of /Talus/motions.
struct StoredMotion {
  double direction[3], line[3], axis[3], rotation_share;
  std::int32_t mode, came_to_rest, joints[2], against[2];
};

StoredMotion stored(const MotionClass& motion);
MotionClass restored(const StoredMotion& row);

/// The compound type of such rows, its fields named as above.
hdf5::Handle stored_motion_type();

}  // namespace talus
