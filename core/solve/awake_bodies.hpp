#pragma once

#include <vector>

namespace talus {

struct SimulationState;

/// Which bodies are held, by the stage or by sleep, and what follows from it. A held body has no unknowns.

/// Holds the bodies that the stage holds or that sleep, a flag each, with the stress that they have now.
void hold_bodies(SimulationState& s, const std::vector<char>& asleep);

/// Some bodies fell asleep or woke: holds and releases them, and tells detection, equations and first guess.
void update_sleepers(SimulationState& s);

}  // namespace talus
