#pragma once

namespace talus {

struct SimulationState;

/// Finds the contact points that may bear in a step of `length` [s] from the present positions.
void seek_contacts(SimulationState& s, double length);

/// Finds the contact points of a step that is about to be tried, [s]: puts those to sleep that are to, wakes whom
/// somebody awake may touch, and sets the pattern of the equations where couplings have changed.
void detect_contacts(SimulationState& s, double length);

}  // namespace talus
