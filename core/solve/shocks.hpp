#pragma once

#include <vector>

#include "bodies/body_set.hpp"
#include "contact/contact_point.hpp"

namespace talus {

/// Bodies on which the push of others has just come or gone. An integrator that goes on with the acceleration of the
/// last step, β ≠ ½, takes a blow for lasting: it holds −(β − ½)Δ²a₀ of it into the next step, which throws a block
/// that has landed up again, with energy from nothing. What such a body goes on with is the acceleration of a free
/// fall.
class Shocks {
 public:
  explicit Shocks(const BodySet& set) : pushes_(set.bodies.size(), Vec3::Zero()), before_(pushes_) {}

  /// A step is taken: how contacts push at its end.
  void look(const BodySet& set, const ContactSet& contacts, const std::vector<ContactOutcome>& outcomes);
  /// Accelerations are those at its end; bodies that have taken a blow go on with gravity's [m/s²].
  void forget(BodySet& set, const Vec3& gravity) const;

 private:
  std::vector<Vec3> pushes_, before_;  // N, all normal forces on a body; of one asleep as it fell asleep
};

}  // namespace talus
