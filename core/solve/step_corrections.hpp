#pragma once

namespace talus {

struct SimulationState;

/// What a converged step shows to be wrong is corrected before it converges again: contacts that go deeper than the
/// tolerance get the normal that their features have at the end of the step, a stiffer spring or, in static stages, a
/// larger multiplier. Whether any did.
bool correct(SimulationState& s);

}  // namespace talus
