#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "command.hpp"
#include "verification/verify_hard_cases.hpp"

namespace talus::cli {

/// What `verify --hard-cases` was asked for.
struct HardCasesRequest {
  std::vector<std::string> names;
  std::string group;  ///< empty: all
  bool all = false, list = false;
  int perturbations = 0;           ///< how often each scene is run again, hardly changed
  std::filesystem::path markdown;  ///< page to write into; empty: none
  TrialOptions options;
};

/// Runs the hard cases, or lists them. Throws InputError for names there are not.
ExitCode run_hard_cases(const HardCasesRequest& request, bool json);

}  // namespace talus::cli
