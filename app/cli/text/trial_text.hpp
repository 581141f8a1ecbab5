#pragma once

#include <string>
#include <vector>

#include "verification/hard_cases/trial.hpp"

namespace talus::cli {

/// What the columns of a scene's row mean; once, above the first scene.
std::string trial_columns();
/// A scene's row, and below it in words what did not hold.
std::string trial_text(const Trial& trial);

/// The list of scenes there are.
std::string list_text(const std::vector<HardCase>& scenes);

}  // namespace talus::cli
