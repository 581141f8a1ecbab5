#pragma once

#include <string>
#include <vector>

#include "verification/hard_cases/trial.hpp"

namespace talus::cli {

/// A scene's row, below it what it is, and in words what did not hold.
std::string random_trial_text(const Trial& trial);
/// A row a family: scenes, how many held, what did not, seconds.
std::string families_text(const std::vector<Trial>& trials);
/// The families there are.
std::string family_list_text();

}  // namespace talus::cli
