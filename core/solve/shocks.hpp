#pragma once

#include <vector>

#include "bodies/body_set.hpp"
#include "contact/contact_point.hpp"
#include "effects/effect.hpp"

namespace talus {

/// Bodies on which the push of others has just come or gone. An integrator that goes on with the acceleration of the
/// last step, β ≠ ½, takes a blow for lasting: it holds −(β − ½)Δ²a₀ of it into the next step, which throws a block
/// that has landed up again, and gives (β − ½)Δ²·m a₁(a₀ − a₁) to one on which a push dies away (what cannot grow is
/// the kinetic energy with ½(β − ½)Δ²·m a² on top). Such a body goes on without an acceleration.
class Shocks {
 public:
  explicit Shocks(const BodySet& set)
      : pushes_(set.bodies.size(), Vec3::Zero()),
        before_(pushes_),
        struck_(set.bodies.size(), false),
        slackened_(struck_) {}

  /// A step is taken: how contacts push at its end.
  void look(const BodySet& set, const ContactSet& contacts, const std::vector<ContactOutcome>& outcomes);
  /// Accelerations are those at its end; bodies that have taken a blow go on without one.
  void forget(BodySet& set);
  /// A step has settled at `d`: bodies that came without an acceleration, or whose acceleration is over or dies away in
  /// it, take it anew with the one that they end with. Whether there are any.
  bool slacken(BodySet& set, const StepContext& step, const Increment& d);

 private:
  bool lets_go(int body, const BodySet& set, const StepContext& step, const Increment& d) const;
  std::vector<Vec3> pushes_, before_;  // N, all normal forces on a body; of one asleep as it fell asleep
  std::vector<bool> struck_;           // a body: by the step before, and goes on without an acceleration
  std::vector<bool> slackened_;        // a body: has taken this step anew
};

}  // namespace talus
