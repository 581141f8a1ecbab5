#pragma once

#include <optional>
#include <vector>

#include "contact/contact_detector.hpp"
#include "effects/contact_links.hpp"

namespace talus {

/// Contacts that a step would find too late. A step knows what may touch by the features as they stand at its start:
/// where a block turns, an edge may come to bear that no normal of the start would let bear. By the next step it is
/// deep.
class LateContacts {
 public:
  explicit LateContacts(const BodySet& set) : set_(set), end_(set.nodes.position.size()), ways_(set.bodies.size()) {}

  /// The deepest contact at the end of a step that has settled at `d`, if it is deeper, by more than `tolerance` of its
  /// mesh size, than the deepest of those that the step knows between the same two blocks; of these no more than
  /// `tolerance` counts, or what one contact is wrong by would let the next one in. Looked for where a block turns, so
  /// that one of its nodes goes `least_turn` [m] or more against the others; nowhere else do features come to bear all
  /// of a sudden. `reach`: as for detect() of this step. The detector is told of the motion there and back.
  std::optional<ContactDetector::Late> seek(ContactDetector& detector, const ContactLinks& links, const Increment& d,
                                            double reach, double tolerance, double least_turn);

 private:
  bool turns(const Increment& d, double least_turn) const;
  void place_nodes(const Increment& d);
  void tell(ContactDetector& detector) const;
  double known_depth(const ContactDetector::Late& late, const ContactLinks& links, const Increment& d) const;
  const BodySet& set_;
  std::vector<Vec3> end_;     // m, of all nodes
  std::vector<double> ways_;  // m, a body
};

}  // namespace talus
