#pragma once

#include <span>
#include <vector>

#include "bodies/body_set.hpp"
#include "contact/contact_point.hpp"
#include "model/project.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// Which springs are no stiffer than the steps of a stage can follow.
enum class FollowedContacts {
  none,
  new_ones,  ///< those that go on keep theirs, for softened ones sink
  all,
};

/// Springs of contacts: no stiffer than the step can follow. Those between two bodies of masses m₁ and m₂ are together
/// at most (ωΔ/Δ)² / (1/m₁ + 1/m₂): stiffer ones give the same motion in many more iterations ("near-rigid" contact,
/// Castro, Permenter & Han 2022). Nor are they so soft that the lighter body's weight would press them deeper than is
/// allowed, nor, on a body with elements, softer than these; nor softer than the stiffest that goes on between the same
/// bodies, which has shown what they need. Joints keep a stiffness of their own.
class FollowedSprings {
 public:
  /// `bodies` outlive them.
  FollowedSprings(const BodySet& bodies, const FollowedSpringTolerances& tolerances)
      : bodies_(bodies), tolerances_(tolerances) {}

  /// Limits the springs of these contacts in a step of `length` [s]. `penetration`: of h, that contacts may have. Of
  /// those that go on and get softer, the shear force falls, so that they hold no more energy.
  void limit(const Project& project, double length, double penetration, FollowedContacts which, ContactSet& contacts);

 private:
  double limit_of(const ContactPoint& point, double length, double gravity, double penetration) const;

  const BodySet& bodies_;
  FollowedSpringTolerances tolerances_;
  std::vector<int> by_pair_;  // numbers of the points that count, sorted by their bodies
};

}  // namespace talus
