#pragma once

#include "effects/compose.hpp"
#include "results/frame.hpp"
#include "results/run_report.hpp"

namespace talus {

/// What a contact point came to when a step was taken, for frames and events.
struct ContactForces {
  double normal = 0;          ///< N, compression positive
  Vec3 shear = Vec3::Zero();  ///< N, on the first body
  double gap = 0;             ///< m, at the end of the step
  ContactMode mode = ContactMode::open;
};

/// What the contact points come to at the increment of a step that is taken.
class ContactOutcomes {
 public:
  /// `links` are those of `contacts`. `keep_multipliers`: the augmented Lagrangian goes on with the normal forces. Sets the modes of the points.
  void take(ContactSet& contacts, const ContactLinks& links, const Composition& composition, const Increment& d,
            bool keep_multipliers);

  const std::vector<ContactForces>& forces() const { return forces_; }
  const std::vector<ContactOutcome>& outcomes() const { return outcomes_; }
  /// Counts and penetrations of the step.
  void add_to(StepReport& report, const ContactSet& contacts) const;
  std::vector<ContactSample> samples(const ContactSet& contacts) const;

 private:
  std::vector<ContactForces> forces_;
  std::vector<ContactOutcome> outcomes_;
};

/// Deepest penetration of a point that pushes, of its mesh size, at D.
double relative_penetration(const ContactLinks& links, const Increment& d);

/// A round of the augmented Lagrangian (Simo & Laursen 1992): what each point bears at D it bears from now on without
/// penetration, λ ← max(0, λ − k_n gap).
void raise_multipliers(ContactSet& contacts, const ContactLinks& links, const Increment& d);

}  // namespace talus
