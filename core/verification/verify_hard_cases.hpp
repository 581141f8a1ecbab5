#pragma once

#include <functional>
#include <string>
#include <vector>

#include "verification/hard_cases/trial.hpp"

/// The hard cases, as a list that a user chooses from and runs.
namespace talus {

/// Those named, in that order; without names all that are quick, or all. Where `group` is not empty only those of it.
/// Throws InputError for a name or a group there is not.
std::vector<HardCase> chosen_hard_cases(const std::vector<HardCase>& scenes, const std::vector<std::string>& names,
                                        bool all, const std::string& group);

/// Runs all of them and hands each trial on as it comes. Throws Cancelled when `progress` says so.
void verify_hard_cases(const std::vector<HardCase>& scenes, const TrialOptions& options, Progress& progress,
                       const std::function<void(const Trial&)>& ended);

}  // namespace talus
