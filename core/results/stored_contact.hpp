#pragma once

#include <cstdint>

#include "results/frame.hpp"
#include "results/hdf5.hpp"

namespace talus {

/// A contact sample as a row of /Talus/contacts.
struct StoredContact {
  double position[3], normal[3], shear_force[3], normal_force, area;
  std::int32_t blocks[2], joint, state;
};

StoredContact stored(const ContactSample& sample);
ContactSample restored(const StoredContact& row);

/// The compound type of such rows, its fields named as above.
hdf5::Handle stored_contact_type();

}  // namespace talus
