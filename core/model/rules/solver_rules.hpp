#pragma once

#include "model/solver_settings.hpp"

namespace talus {

/// The rules of how a scene is solved. Throws InputError for the first that is broken.
void check(const SolverSettings& solver);

}  // namespace talus
