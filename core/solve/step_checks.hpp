#pragma once

#include <optional>
#include <span>

#include "contact/detection/contact_detector.hpp"
#include "contact/passage/passage.hpp"

namespace talus {

struct SimulationState;

/// No part of a step of this length is cut below it [s].
double shortest_part(const SimulationState& s, double length);

/// What forbids to accept a step although it has converged.

/// The first element that the increment turns inside out; −1: none.
int inverted_element(const SimulationState& s);

/// Whether what a dynamic step has left to be mended may be left to a shorter one: this is no part that has been cut as
/// short as parts may be.
bool may_look_again(const SimulationState& s);

/// Contacts that the step did not know of, where blocks turn into each other in it, the deepest first. Looked for as
/// long as may_look_again().
std::span<const ContactDetector::MissedContact> missed_contacts(SimulationState& s);

/// Two blocks that the increment takes deeper into or through each other than any contact between them says.
std::optional<DeepPair> passage(SimulationState& s);

}  // namespace talus
