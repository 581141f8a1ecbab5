#pragma once

#include <functional>
#include <vector>

#include "contact/contact_links.hpp"
#include "contact/detection/contact_detector.hpp"

namespace talus {

/// Gives contacts that slide the normal that their features will have in the middle of the step, as `middle_normal`
/// tells: about it the gap at the end follows from that at the start to third order in the step (docs/theory.md, "One
/// place"). `sliding`: how far the bodies of a point will move against each other [m], as far as that can be foreseen.
/// Both are asked on several cores at once. Bonded points neither slide nor rotate.
void foresee_normals(ContactSet& contacts, const std::function<Vec3(const ContactPoint&)>& sliding,
                     const std::function<Vec3(int point)>& middle_normal, const ContactTolerances& tolerances);

/// Updates the normals of contacts that a converged step would let go too deep. A step holds the normal that was
/// foreseen, which errs by how far a contact slides times the angle by which its features rotate otherwise; and it
/// takes two rigid bodies that come from afar to turn about one place (Meeting), which errs by how far they were apart
/// times the angle by which they turn.
class NormalUpdate {
 public:
  /// A point gets the normal that its features have at the increment `d`, and the gap that they have there, as
  /// `updated_normal` tells on several cores at once, if it is deeper so than `tolerance` of its mesh size, and deeper
  /// than the step knows. Bonded points neither slide nor rotate.
  /// `links` are those of `contacts`. Returns whether any normal was updated: then the step must converge again.
  bool update(ContactSet& contacts, const ContactLinks& links,
              const std::function<ContactDetector::UpdatedNormal(int point)>& updated_normal, const Increment& d,
              double tolerance, const ContactTolerances& tolerances);

 private:
  struct Slide {
    int point;
    Vec3 displacement;  // m
    ContactDetector::UpdatedNormal at_end;
  };
  std::vector<Slide> slides_;
};

}  // namespace talus
