#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "command.hpp"
#include "verification/verify_random.hpp"

namespace talus::cli {

/// What `verify --random` or `--random-scene` was asked for.
struct RandomRequest {
  int count = 0;                    ///< to draw
  std::string seed = "1";           ///< a number, or "now"
  std::vector<std::string> scenes;  ///< names, instead of drawing
  std::vector<std::string> families;
  std::string bodies;           ///< empty: drawn
  bool other_settings = false;  ///< the same scenes, solved by others that must not matter
  bool list = false;
  std::filesystem::path folder;    ///< for scenes that fail; empty: they are not written
  std::filesystem::path markdown;  ///< page to write into; empty: none
  TrialOptions options;
};

/// Draws scenes and runs them, or lists the families. Throws InputError for what there is not.
ExitCode run_random(const RandomRequest& request, bool json);

}  // namespace talus::cli
