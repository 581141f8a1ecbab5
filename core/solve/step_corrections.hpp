#pragma once

namespace talus {

struct SimulationState;

/// What a converged step shows to be wrong, and what is corrected before it converges again.

/// Contacts that go deeper than the tolerance get the normal that their features have at the end of the step, a stiffer
/// spring or, in static stages, a larger multiplier. Whether any did.
bool correct_contacts(SimulationState& s);

/// Bodies after a blow begin the step with the acceleration that they end it with. Whether any do.
bool correct_accelerations(SimulationState& s);

}  // namespace talus
