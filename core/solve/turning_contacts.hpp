#pragma once

#include <functional>

#include "contact/contact_detector.hpp"
#include "effects/contact_links.hpp"

namespace talus {

/// A step knows a contact by the normal at its start, which is wrong by how far it slides times the angle by which it
/// turns. Gives points that in truth go deeper than `tolerance` of their mesh size by D, and deeper than the step
/// knows, the normal that `turned` tells of their features at D. Bonded ones neither slide nor turn. Whether any was.
/// `links` are those of `contacts`.
bool follow_turning(ContactSet& contacts, const ContactLinks& links,
                    const std::function<ContactDetector::Turned(int point)>& turned, const Increment& d,
                    double tolerance);

}  // namespace talus
