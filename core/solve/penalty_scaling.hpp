#pragma once

#include <span>
#include <utility>
#include <vector>

#include "contact/contact_links.hpp"
#include "model/project.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// Penalty scaling, as in Shi's programs: contacts that penetrate too deep get stiffer springs. What needs them is a
/// pair of bodies, such as a chip that boulders squeeze, not one of its points, so that all points of the pair get
/// them: else one after the other would go too deep.
class PenaltyScaling {
 public:
  explicit PenaltyScaling(const PenaltyScalingTolerances& tolerances = {}) : tolerances_(tolerances) {}

  /// Looks for points that penetrate by more than `tolerance` of their mesh size at D, and by more than at the start of
  /// the step. The springs of their bodies become ten times as stiff, in shear too; a hundred times, where that has
  /// been done in this step and did not do. The force at the start of the step stays as it is; the penetration that
  /// this force no longer needs becomes initial interference, which bears nothing. Left alone are bonded points, and
  /// points that are deep by initial interference alone, whose spring hardly gives. Where `as_given` has joints, points
  /// of a joint with a normal stiffness of its own keep that. Whether any spring was scaled.
  bool scale(ContactSet& contacts, const ContactLinks& links, const Increment& d, double tolerance,
             std::span<const Joint> as_given);

 private:
  bool may_stiffen(const ContactPoint& point, std::span<const Joint> as_given) const;
  bool is_too_deep(const ContactPoint& point, double gap, double limit) const;
  void stiffen(ContactPoint& point) const;

  PenaltyScalingTolerances tolerances_;
  std::vector<std::pair<int, int>> pairs_;  ///< of bodies, with a point that is too deep
};

}  // namespace talus
