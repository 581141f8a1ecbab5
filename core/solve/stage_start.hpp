#pragma once

namespace talus {

struct SimulationState;

/// Sets up the stage in which the clock stands: who is held, joint laws, effects, time integration, initial velocities.
void begin_stage(SimulationState& s);

}  // namespace talus
