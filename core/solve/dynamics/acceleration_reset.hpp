#pragma once

#include <vector>

#include "bodies/body_set.hpp"
#include "contact/contact_point.hpp"
#include "effects/effect.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// Resets the acceleration of bodies after blows, that is, after contact forces that came or went within a step.
///
/// An integrator with β ≠ ½ goes on with the acceleration a₀ of the last step. After a blow that is wrong: a force that
/// acted for a moment is taken to last, and (½ − β)Δ²a₀ of it enters the next increment, which throws a block that has
/// just landed up again. A blow that dies away over a step, from a₀ to a₁, returns the energy (β − ½)Δ²·m a₁(a₀ − a₁)
/// to the body. (What cannot grow is not the kinetic energy, but the sum of it and ½(β − ½)Δ²·m a².) So
///   - a body that has taken a blow starts its next step without an acceleration (`drop_after_blows`);
///   - a step that has converged is converged again with a₀ = a₁ for bodies that came without an acceleration, and for
///     bodies whose acceleration has ended or dies away in it (`reset_to_end`).
class AccelerationReset {
 public:
  explicit AccelerationReset(const BodySet& set, const AccelerationResetTolerances& tolerances = {})
      : tolerances_(tolerances),
        forces_(set.bodies.size(), Vec3::Zero()),
        before_(forces_),
        was_hit_(set.bodies.size(), false),
        was_reset_(was_hit_) {}

  /// A step is accepted: takes the contact forces at its end.
  void note_contact_forces(const BodySet& set, const ContactSet& contacts, const std::vector<ContactOutcome>& outcomes);
  /// After that, with accelerations as at the end of the step: bodies that have taken a blow lose theirs.
  void drop_after_blows(BodySet& set);
  /// A step has converged at `d`: where it is called for, accelerations at its start become those at its end. Whether
  /// any did; then the step is to be converged again.
  bool reset_to_end(BodySet& set, const StepContext& step, const Increment& d);

 private:
  bool needs_reset(int body, const BodySet& set, const StepContext& step, const Increment& d) const;

  AccelerationResetTolerances tolerances_;
  std::vector<Vec3> forces_, before_;  // N, all normal forces on a body; of one asleep as it fell asleep
  std::vector<bool> was_hit_;          // a body: in the step before, and goes on without an acceleration
  std::vector<bool> was_reset_;        // a body: in this step
};

}  // namespace talus
