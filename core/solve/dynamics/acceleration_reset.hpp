#pragma once

#include <utility>
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
///   - a body that has taken a blow goes on without an acceleration (`drop_after_blows`), and begins its next step with
///     the one that it ends it with, a₀ = a₁, if that moves it;
///   - so do bodies of which a step, once it has converged, shows that their acceleration ends or dies away in it; the
///     step is converged again (`correct`).
/// a₀ = a₁ gives nothing back and is exact for a constant force: there the integrator of a rigid body is Newmark's with
/// β = ½. That would let the waves of a body that deforms ring on: there a₀ becomes the a₁ that the step has converged
/// to first, which is less than a ninth of the change away from it.
class AccelerationReset {
 public:
  /// `sizes`: mesh sizes of the bodies [m].
  AccelerationReset(const BodySet& set, std::vector<double> sizes, const AccelerationResetTolerances& tolerances = {})
      : tolerances_(tolerances),
        sizes_(std::move(sizes)),
        forces_(set.bodies.size(), Vec3::Zero()),
        before_(forces_),
        was_hit_(set.bodies.size(), false),
        goes_on_(was_hit_),
        was_changed_(was_hit_) {}

  /// Nothing is known of blows any more.
  void begin_stage(BodySet& set);
  /// A step is about to be tried: says of each body whether it begins with the acceleration that it ends with.
  void begin_step(BodySet& set);
  /// It has converged at `d`: says so of the bodies for which `d` calls for it, and not of those that it would throw
  /// back. Of each body that changes once a step. Whether any did; then the step is to be converged again.
  bool correct(BodySet& set, const StepContext& step, const Increment& d);
  /// A step is accepted: takes the contact forces at its end.
  void note_contact_forces(const BodySet& set, const ContactSet& contacts, const std::vector<ContactOutcome>& outcomes);
  /// After that, with velocities as at the start of the step: finds the bodies that have taken a blow in it.
  void find_blows(const BodySet& set, const StepContext& step, const Increment& d);
  /// After that, with accelerations as at the end of the step: bodies that have taken a blow lose theirs.
  void drop_after_blows(BodySet& set) const;

  /// How the acceleration of a body changes over a step: sums over its parts, weighed by mass but for a common factor.
  struct AccelerationChange {
    double before = 0;    ///< a₀·a₀
    double after = 0;     ///< a₁·a₁
    double returned = 0;  ///< a₁·(a₀ − a₁), what the step returns to the body
    double change = 0;    ///< (a₀ − a₁)·(a₀ − a₁)
    double motion = 0;    ///< v₀·v₀
    double along = 0;     ///< v₀·a₁

    void add(const Vec3& v0, const Vec3& a0, const Vec3& a1, const Mat3& weight = Mat3::Identity());
  };

 private:
  /// Whether an acceleration of this square [m²/s⁴] moves a body in a step.
  bool is_visible(int body, double square, const StepContext& step) const;
  bool is_constant(int body, bool is_constant_now, const AccelerationChange& a, const StepContext& step) const;

  AccelerationResetTolerances tolerances_;
  std::vector<double> sizes_;
  std::vector<Vec3> forces_, before_;  // N, all normal forces on a body; of one asleep as it fell asleep
  std::vector<bool> was_hit_;          // a body: in the step before, and goes on without an acceleration
  std::vector<bool> goes_on_;          // a body: was hit, and moves by what it ended that step with
  std::vector<bool> was_changed_;      // a body: in this trial
};

}  // namespace talus
