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
  /// How deep points may be, of their mesh size: by what their spring gives now, and in all.
  struct Depths {
    double spring, in_all;
  };

  /// `bodies` outlive it.
  explicit PenaltyScaling(const BodySet& bodies, const PenaltyScalingTolerances& tolerances = {})
      : bodies_(bodies), tolerances_(tolerances) {}

  /// Looks for points whose spring gives by more than it may at D, or that are deeper in all than they may be, and
  /// that are deeper than at the start of the step. `in_all` is for faces that lie on each other, of bodies that do not
  /// move by elements: two blocks sink into what carries them, and the strip with which one comes to lie on the other's
  /// neighbour is found as deep as both have come, but need not bear what they do. Other points may be no deeper in all
  /// than a spring may give. The springs of their bodies become ten times as stiff, in shear too; a hundred times,
  /// where that has been done in this step and did not do. The force at the start of the step stays as it is; the
  /// penetration that this force no longer needs becomes initial interference, which bears nothing. Left alone are
  /// bonded points, and points that are deep by initial interference alone, whose spring hardly gives. Where `as_given`
  /// has joints, points of a joint with a normal stiffness of its own keep that. Whether any spring was scaled.
  bool scale(ContactSet& contacts, const ContactLinks& links, const Increment& d, const Depths& allowed,
             std::span<const Joint> as_given);

 private:
  bool may_stiffen(const ContactPoint& point, std::span<const Joint> as_given) const;
  bool is_too_deep(const ContactPoint& point, double gap, const Depths& allowed) const;
  void stiffen(ContactPoint& point) const;

  const BodySet& bodies_;
  PenaltyScalingTolerances tolerances_;
  std::vector<std::pair<int, int>> pairs_;  ///< of bodies, with a point that is too deep
};

}  // namespace talus
