#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "command.hpp"
#include "study/verify_stability.hpp"

namespace talus::cli {

/// What `verify --stability` was asked for.
struct StabilityRequest {
  std::vector<std::string> names;
  std::string group;  ///< empty: all
  bool all = false, list = false;
  int nudges = 0;                  ///< how often each scene is run again, hardly changed
  std::filesystem::path markdown;  ///< page to write into; empty: none
  TrialOptions options;
};

/// Runs the scenes of the stability suite, or lists them. Throws InputError for names there are not.
ExitCode run_stability(const StabilityRequest& request, bool json);

}  // namespace talus::cli
