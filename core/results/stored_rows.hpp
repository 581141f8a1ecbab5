#pragma once

#include <cstdint>

#include "results/frame.hpp"
#include "results/hdf5.hpp"
#include "results/motion_class.hpp"

namespace talus {

/// A contact sample as a row of /Talus/contacts.
struct StoredContact {
  double position[3], normal[3], shear_force[3], normal_force, area;
  std::int32_t blocks[2], joint, state;
  double friction, cohesion;
  std::int32_t bond;
};

/// What a row is before it is read: of results that earlier versions have written HDF5 leaves fields as they are that
/// the file does not have.
StoredContact unknown_contact();

StoredContact stored(const ContactSample& sample);
ContactSample restored(const StoredContact& row);

/// The compound type of such rows, its fields named as above.
hdf5::Handle stored_contact_type();

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
