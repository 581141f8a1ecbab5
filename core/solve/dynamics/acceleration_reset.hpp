#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bodies/body_set.hpp"
#include "contact/contact_links.hpp"
#include "model/solver_tolerances.hpp"
#include "solve/dynamics/free_flight.hpp"

namespace talus {

/// Decides which bodies go on with the acceleration of the last step.
///
/// An integrator with β ≠ ½ lets (½ − β)Δ²a₀ of the last acceleration into the next increment. After a blow, that is, a
/// contact force that came or went within a step, this is wrong: a force that acted for a moment is taken to last, and
/// throws a block that has just landed up again. Nor may a step give back what none has paid for (IntegrationReserve).
/// So
///   - a rigid body begins a step with the acceleration that it ends it with, a₀ = a₁: the integrator is Newmark's with
///     β = ½ then, exact for a constant force, and gives nothing back. It does not damp. One that swings on a stiff
///     contact, so that its acceleration turns from step to step without a blow, is integrated with β ≠ ½ until it is
///     calm or hit;
///   - so does a body that deforms, as long as it flies freely: waves that would ring on FreeFlight calms;
///   - a body goes on without an acceleration after a blow, and after a step of β = ½, which has paid for none.
/// β = ½ would let the waves of a body that deforms ring on its contacts: there the last acceleration counts but after
/// blows.
class AccelerationReset {
 public:
  explicit AccelerationReset(const BodySet& set, const AccelerationResetTolerances& tolerances = {})
      : tolerances_(tolerances),
        forces_(set.bodies.size(), Vec3::Zero()),
        before_(forces_),
        pasts_(set.bodies.size()),
        was_hit_(set.bodies.size(), false),
        goes_on_(was_hit_) {}

  /// Nothing is known of blows and swings any more; rigid bodies begin with a₀ = a₁.
  void begin_stage(BodySet& set);
  /// And so do those that deform, in the first step of a stage, where all contacts are open by more than `touching`, of
  /// the mesh size.
  void let_fly(const BodySet& set, const ContactSet& contacts, double touching);
  /// Where `d` leads to, nothing pushes some bodies that deform, and all their contacts are open by more than
  /// `touching`, of the mesh size: they fly in this step. Whether there are any.
  bool take_off(BodySet& set, const ContactLinks& links, const Increment& d, double touching);
  /// A step is about to be tried: says of each body whether it begins with the acceleration that it ends with.
  void begin_step(BodySet& set) const;
  /// A step is accepted, and velocities are still those at its start: finds the bodies that have taken a blow, by the
  /// contact forces at its end.
  void note_start(const BodySet& set, const ContactSet& contacts, const std::vector<ContactOutcome>& outcomes);
  /// Accelerations are those at the end of the step: takes from bodies those that do not go on. One that deforms and
  /// flies keeps it: the next step begins without, but the error of time integration is measured against it.
  void drop(BodySet& set, const FreeFlight& free_flight) const;
  /// Velocities are those with which the next step begins, after impacts: finds the bodies that swing. `length`: of the
  /// step [s].
  void end_step(const BodySet& set, double length, const FreeFlight& free_flight);

  /// What it remembers from step to step.
  void archive(auto& state) { state(forces_, before_, pasts_, touches_, was_hit_, goes_on_); }

 private:
  /// Of a rigid body, and of its rotation.
  struct Pair {
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();

    void archive(auto& state) { state(linear, angular); }
  };
  struct Past {
    Pair start;                        // velocity [m/s] and angular momentum [kg m²/s] at the start of the step
    std::optional<Pair> acceleration;  // mean of the last step, with impacts [m/s², N m]
    std::optional<Pair> change;        // of that to the one before

    void archive(auto& state) { state(start, acceleration, change); }
  };
  /// Which bodies have a contact that is open by no more than `touching`, of the mesh size. `gap`: of a point [m].
  void note_touching(const BodySet& set, const ContactSet& contacts, const std::function<double(int)>& gap,
                     double touching);
  bool swings(const RigidBody& rigid, const Vec3& velocity, double length, bool swung, Past& past) const;

  AccelerationResetTolerances tolerances_;
  std::vector<Vec3> forces_, before_;  // N, all normal forces on a body; of one asleep as it fell asleep
  std::vector<Past> pasts_;            // a body
  std::vector<char> touches_;          // a body: where it was asked for last
  std::vector<bool> was_hit_;          // a body: in the step before
  std::vector<bool> goes_on_;          // a body: begins its next step with a₀ = a₁
};

}  // namespace talus
