#pragma once

#include <string>

#include "model/solver_settings.hpp"
#include "verification/random/scene_numbers.hpp"

namespace talus {

/// Settings that change how a scene is solved, and must not change what holds of it: how deep contacts may go, how many
/// iterations a step may take, what adaptive steps keep to, whether blocks sleep, which are balanced by themselves, and
/// what is there without being called for. The scheme stays Talus's own: what the paper's holds is another question.
SolverSettings other_settings(SceneNumbers& numbers, SolverSettings settings);

/// Those that differ, by the words of the project file: "penetration_tolerance 1.2e-04, elimination off".
std::string changed_settings(const SolverSettings& before, const SolverSettings& after);

}  // namespace talus
