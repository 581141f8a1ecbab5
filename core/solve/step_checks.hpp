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

/// Contacts that the step did not know of, where blocks turn into each other in it, the deepest first. Looked for in
/// dynamic stages, as long as a shorter step may still be tried.
std::span<const ContactDetector::MissedContact> missed_contacts(SimulationState& s);

/// Two blocks that the increment takes deeper into or through each other than any contact between them says.
std::optional<DeepPair> passage(SimulationState& s);

}  // namespace talus
