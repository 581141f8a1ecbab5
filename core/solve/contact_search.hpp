#pragma once

#include <span>

#include "contact/detection/contact_detector.hpp"

namespace talus {

struct SimulationState;

/// Finds who can come to touch somebody in the steps ahead, if gaps up to `reach` [m] are looked for.
void look_for_company(SimulationState& s, double reach);

/// Puts the effects of contact into the composition once somebody can touch somebody.
void let_touch(SimulationState& s);

/// Finds the contact points that may bear in a step of `length` [s] from the present positions.
void seek_contacts(SimulationState& s, double length);

/// Finds the contact points of a step that is about to be tried, [s]: holds those who have fallen asleep and lets go
/// those who woke, and sets the pattern of the equations where couplings have changed.
void detect_contacts(SimulationState& s, double length);

/// Takes contacts that a converged step has missed into it, so that it can converge with them; the others keep what the
/// step has corrected. Not where one of their
/// bodies sleeps, which has to wake first: whether it did.
bool take_in(SimulationState& s, std::span<const ContactDetector::MissedContact> missed);

}  // namespace talus
