#pragma once

#include <span>

#include "effects/compose.hpp"
#include "results/frame.hpp"
#include "results/run_report.hpp"

namespace talus {

/// What the contact points come to at the increment of a step that is taken.
class ContactOutcomes {
 public:
  /// `links` are those of `contacts`. `keep_multipliers`: the augmented Lagrangian goes on with those of this step, so
  /// that what does not move is pushed as before. Sets the modes of the points.
  void take(ContactSet& contacts, const ContactLinks& links, const Composition& composition, const Increment& d,
            bool keep_multipliers);

  const std::vector<ContactOutcome>& outcomes() const { return outcomes_; }
  const std::vector<ContactSample>& samples() const { return samples_; }
  /// Counts and penetrations of the step.
  void add_to(StepReport& report) const;

 private:
  std::vector<ContactOutcome> outcomes_;
  std::vector<ContactSample> samples_;
  double max_penetration_ = 0, max_relative_penetration_ = 0;  ///< m; of the local mesh size
};

/// A contact of blocks that sleep, as it was when they fell asleep.
ContactSample sample_of(const RestingContact& contact);

/// By how much a point penetrates at D, or pushes across a gap, at most: of its mesh size. A multiplier that is left
/// too large would push blocks apart that touched with less, and make energy.
double multiplier_error(const ContactLinks& links, const Increment& d);

/// A round of the augmented Lagrangian (Simo & Laursen 1992): what each point bears at D it bears from now on without
/// penetration, λ ← max(0, λ − k_n gap).
void adapt_multipliers(ContactSet& contacts, const ContactLinks& links, const Increment& d);

/// Hardens points, against shear too, that penetrate by more than `tolerance` of their mesh size at D and by more than
/// at the start of the step (the penalty × 10 of Shi's programs): the force at the start stays what it is, what it is
/// deep by then stays out of account. Not where that alone is too deep, and the spring hardly gives. Where `as_given`
/// has joints, points of one with a normal stiffness of its own keep that. Whether any was hardened.
bool harden(ContactSet& contacts, const ContactLinks& links, const Increment& d, double tolerance,
            std::span<const Joint> as_given);

}  // namespace talus
