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
/// bodies, which has shown what they need. Springs that a blow has made stiffer than rock and that hardly give any more
/// are let go soft again, else every blow that blocks have had stays in their springs and makes the next step harder.
/// Joints keep a stiffness of their own.
class FollowedSprings {
 public:
  /// `bodies` outlive them.
  FollowedSprings(const BodySet& bodies, const FollowedSpringTolerances& tolerances)
      : bodies_(bodies), tolerances_(tolerances) {}

  /// Limits the springs of these contacts in a step of `length` [s]. `penetration`: of h, that contacts may have. Of
  /// those that go on and get softer the forces fall, so that they hold no more energy.
  void limit(const Project& project, double length, double penetration, FollowedContacts which, ContactSet& contacts);

 private:
  double limit_of(const ContactPoint& point, double length, double gravity, double penetration) const;
  bool any_moves(std::span<const int> points, double length, double penetration, const ContactSet& contacts) const;
  /// Softens the springs of points that go on between two bodies, no farther than to the scaling `least`, where they
  /// hardly give and the two move; but for points that stiffening and softening by turns has brought too deep into
  /// initial interference. Returns what the scaling of the stiffest becomes.
  double relax(std::span<const int> going_on, double stiffest, double least, double length, double penetration,
               ContactSet& contacts) const;

  const BodySet& bodies_;
  FollowedSpringTolerances tolerances_;
  std::vector<int> by_pair_;   // numbers of the points that count: those of two bodies follow one upon the other
  std::vector<int> going_on_;  // of a pair
};

}  // namespace talus
