#pragma once

#include <span>

#include "effects/compose.hpp"
#include "model/solver_tolerances.hpp"
#include "results/frame.hpp"
#include "results/run_report.hpp"

namespace talus {

/// What the contact points come to at the increment of a step that is taken.
class ContactOutcomes {
 public:
  explicit ContactOutcomes(const ContactOutcomeTolerances& tolerances = {}) : tolerances_(tolerances) {}

  /// `links` are those of `contacts`. `keep_multipliers`: the next step of the augmented Lagrangian begins with those
  /// of this step, so that what does not move is pushed as before. Sets the modes of the points.
  void take(ContactSet& contacts, const ContactLinks& links, const Composition& composition, const Increment& d,
            bool keep_multipliers);

  const std::vector<ContactOutcome>& outcomes() const { return outcomes_; }
  const std::vector<ContactSample>& samples() const { return samples_; }
  /// Counts and penetrations of the step.
  void add_to(StepReport& report) const;

 private:
  ContactOutcomeTolerances tolerances_;
  std::vector<ContactOutcome> outcomes_;
  std::vector<ContactSample> samples_;
  double max_penetration_ = 0, max_relative_penetration_ = 0;  ///< m; of the local mesh size
};

/// A contact of blocks that sleep, as it was when they fell asleep.
ContactSample sample_of(const RestingContact& contact);

/// The largest penetration at D, or gap that a point pushes across, of its mesh size. A multiplier that is left too
/// large would push blocks apart that touched with less, and make energy.
double multiplier_error(const ContactLinks& links, const Increment& d);

/// A round of the augmented Lagrangian (Simo & Laursen 1992): the force of each point at D becomes its multiplier, so
/// that it is borne without penetration, λ ← max(0, λ − k_n gap).
void adapt_multipliers(ContactSet& contacts, const ContactLinks& links, const Increment& d);

}  // namespace talus
