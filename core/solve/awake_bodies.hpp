#pragma once

#include <span>
#include <vector>

#include "contact/detection/contact_detector.hpp"

namespace talus {

struct SimulationState;

/// Which bodies are held, by the stage or by sleep, and what follows from it. A held body has no unknowns.

/// Holds the bodies that the stage holds or that sleep, a flag each, with the stress that they have now.
void hold_bodies(SimulationState& s, const std::vector<char>& asleep);

/// Some bodies fell asleep or woke: holds and releases them, and tells detection, equations and first guess.
void update_sleepers(SimulationState& s);

/// Wakes the sleepers that the increment of a trial step presses otherwise than when they fell asleep, or that it has
/// `missed` contacts with, and those within so many `rings` of contacts (Sleep::wake); of a step that has not converged
/// all that it touches. Whether some wake, so that the step is to be tried again.
bool wake_pressed(SimulationState& s, bool converged, std::span<const ContactDetector::MissedContact> missed,
                  int rings);

}  // namespace talus
