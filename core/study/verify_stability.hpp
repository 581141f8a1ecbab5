#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stability/trial.hpp"

/// The suite of stability, as a list that a user chooses from and runs.
namespace talus {

/// Those named, in that order; without names all that are quick, or all. Where `group` is not empty only those of it.
/// Throws InputError for a name or a group there is not.
std::vector<StabilityScene> chosen_scenes(const std::vector<StabilityScene>& scenes,
                                          const std::vector<std::string>& names, bool all, const std::string& group);

/// Runs all of them and hands each trial on as it comes. Throws Cancelled when `progress` says so.
void verify_stability(const std::vector<StabilityScene>& scenes, const TrialOptions& options, Progress& progress,
                      const std::function<void(const Trial&)>& ended);

}  // namespace talus
