#pragma once

namespace talus {

struct SimulationState;

/// What a converged step shows to be wrong is corrected before it converges again: contacts that go too deep, and the
/// accelerations of bodies that have taken a blow. Whether anything was.
bool correct(SimulationState& s);

}  // namespace talus
