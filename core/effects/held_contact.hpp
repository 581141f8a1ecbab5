#pragma once

#include "contact/contact_point.hpp"

namespace talus {

/// What a contact point does for a round of the paper's open–close iteration, section 3: its springs are there or not,
/// and where it slides friction takes the place of the shear spring. Friction is constant along the sliding; across it,
/// it turns with the displacement of the round itself, to first order.
struct HeldContact {
  bool closed = false;                    ///< the normal spring is there, (29)–(31)
  ContactMode shear = ContactMode::open;  ///< no force; the shear spring (34)(35); friction (36)–(40)
  Vec3 friction = Vec3::Zero();           ///< N, on the first body where it slides
  double across = 0;                      ///< part of the shear spring's force that is borne across friction

  bool same_state(const HeldContact& other) const { return closed == other.closed && shear == other.shear; }
};

}  // namespace talus
