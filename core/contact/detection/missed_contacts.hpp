#pragma once

#include <span>
#include <vector>

#include "contact/contact_links.hpp"
#include "contact/detection/contact_detector.hpp"

namespace talus {

/// Contacts that a step has missed. It knows what may touch from the features as they stand at its start. Where a block
/// rotates, an edge may come into contact whose normals at the start did not allow it; by the next step it is deep.
class MissedContacts {
 public:
  explicit MissedContacts(const BodySet& set)
      : set_(set), end_(set.nodes.position.size()), increments_(end_.size()), displacements_(set.bodies.size()) {
    gone_.ways.resize(set.bodies.size());
  }

  /// The contacts at the end of a step that has converged to the increment `d` that are deeper, by more than
  /// `tolerance` of their mesh size, than the deepest of those that the step knows between the same two blocks, the
  /// deepest first. Of that depth no more than `tolerance` counts, else the error of one contact would hide the next.
  /// None is deeper than it by more than the two have come nearer there. Contacts are looked for only of two blocks of
  /// which one rotates: a node goes `tolerance` of their mesh size or more against the mean of its block; or which went
  /// farther against each other than `foreseen`, what detect() of this step was told. Without that, no feature comes
  /// into contact all of a sudden. `least_rotation` [m]: of no two blocks is that less. The detector is told of the
  /// motion to the end and back, but for bodies that are `alone`, a flag each: they can touch nobody.
  std::span<const ContactDetector::MissedContact> seek(ContactDetector& detector, const ContactLinks& links,
                                                       const Increment& d, const Reach& foreseen, double tolerance,
                                                       double least_rotation, std::span<const char> alone = {});

 private:
  void measure_ways(const Increment& d, std::span<const char> alone);
  bool may_have_missed(const Reach& foreseen, double least_rotation) const;
  void place_nodes(std::span<const char> alone);
  void tell(ContactDetector& detector) const;
  double known_depth(const ContactDetector::MissedContact& contact, const ContactLinks& links,
                     const Increment& d) const;
  const BodySet& set_;
  std::vector<ContactDetector::MissedContact> missed_;
  std::vector<Vec3> end_;              // m, of all nodes
  std::vector<Vec3> increments_;       // m, of the nodes of bodies that are not fixed
  std::vector<double> displacements_;  // m, a body
  Reach gone_;                         // with the ways that bodies went
};

}  // namespace talus
