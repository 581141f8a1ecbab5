#pragma once

#include <vector>

namespace talus {

struct SimulationState;

/// Sets up the stage in which the clock stands: who is held, joint laws, effects, time integration, initial velocities.
void begin_stage(SimulationState& s);

/// Sets up a stage that has begun in another run, for the state in which that run stands: with the effects of contact,
/// and with bodies that are held because they sleep, a flag each.
void set_up_stage(SimulationState& s, int number, bool with_contact, const std::vector<char>& asleep);

}  // namespace talus
