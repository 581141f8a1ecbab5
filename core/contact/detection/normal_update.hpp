#pragma once

#include <functional>

#include "contact/contact_links.hpp"
#include "contact/detection/contact_detector.hpp"

namespace talus {

/// Updates the normals of contacts that a converged step would let go too deep. A step holds the normal of its start,
/// which errs by how far a contact slides times the angle by which its features rotate. A point gets the normal that
/// its features have at the increment `d`, as `updated_normal` tells, if along that one it is deeper than `tolerance`
/// of its mesh size, and deeper than the step knows. Bonded points neither slide nor rotate. `links` are those of
/// `contacts`. Returns whether any normal was updated: then the step must converge again.
bool update_normals(ContactSet& contacts, const ContactLinks& links,
                    const std::function<ContactDetector::UpdatedNormal(int point)>& updated_normal, const Increment& d,
                    double tolerance, const ContactTolerances& tolerances);

}  // namespace talus
