#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "bodies/body_set.hpp"
#include "contact/contact_point.hpp"
#include "effects/effect.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// Decides which bodies go on with the acceleration of the last step.
///
/// An integrator with β ≠ ½ lets (½ − β)Δ²a₀ of the last acceleration into the next increment. After a blow, that is, a
/// contact force that came or went within a step, this is wrong: a force that acted for a moment is taken to last, and
/// throws a block that has just landed up again. Nor may a step give back what none has paid for (IntegrationReserve).
/// So
///   - a rigid body whose acceleration stays much the same, or dies away, begins its next step with the acceleration
///     that it ends it with, a₀ = a₁: the integrator is Newmark's with β = ½ then, exact for a constant force, and
///     gives nothing back. One that swings on a stiff contact, from a₀ to −a₀/3, is damped by β ≠ ½;
///   - a body goes on without an acceleration after a blow, and after a step of β = ½, which has paid for none.
/// β = ½ would let the waves of a body that deforms ring on: there the last acceleration counts but after blows.
class AccelerationReset {
 public:
  /// `sizes`: mesh sizes of the bodies [m].
  AccelerationReset(const BodySet& set, std::vector<double> sizes, const AccelerationResetTolerances& tolerances = {})
      : tolerances_(tolerances),
        sizes_(std::move(sizes)),
        forces_(set.bodies.size(), Vec3::Zero()),
        before_(forces_),
        ends_(set.bodies.size()),
        was_hit_(set.bodies.size(), false),
        goes_on_(was_hit_) {}

  /// Nothing is known of blows any more; rigid bodies begin with a₀ = a₁.
  void begin_stage(BodySet& set);
  /// A step is about to be tried: says of each body whether it begins with the acceleration that it ends with.
  void begin_step(BodySet& set) const;
  /// A step is accepted: takes the contact forces at its end.
  void note_contact_forces(const BodySet& set, const ContactSet& contacts, const std::vector<ContactOutcome>& outcomes);
  /// After that, with velocities as at the start of the step: finds the bodies that have taken a blow in it, and those
  /// that begin the next one with a₀ = a₁.
  void look_at(const BodySet& set, const StepContext& step, const Increment& d);
  /// After that, with accelerations as at the end of the step: takes from bodies those that do not go on.
  void drop(BodySet& set) const;

 private:
  /// Of a rigid body, at the end of its last step.
  struct End {
    Vec3 acceleration = Vec3::Zero(), moment = Vec3::Zero();  // m/s², N m
  };
  bool goes_on_with_the_end(const BodySet& set, int body, const StepContext& step, const Increment& d);

  AccelerationResetTolerances tolerances_;
  std::vector<double> sizes_;
  std::vector<Vec3> forces_, before_;     // N, all normal forces on a body; of one asleep as it fell asleep
  std::vector<std::optional<End>> ends_;  // a body: none before its first step
  std::vector<bool> was_hit_;             // a body: in the step before
  std::vector<bool> goes_on_;             // a body: begins its next step with a₀ = a₁
};

}  // namespace talus
