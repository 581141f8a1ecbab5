#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "project_choice.hpp"
#include "run/run.hpp"

namespace talus::cli {

/// How a project is solved into a results folder.
struct RunChoice {
  std::filesystem::path out;  ///< results folder
  int threads = 1;
  bool resume = false;                                      ///< from the last checkpoint there
  double checkpoint_every = RunOptions{}.checkpoint_every;  ///< s
  std::optional<double> max_wall{};                         ///< s after which the run is stopped; none: no limit
};

/// `given`, or NAME.results beside NAME.talus where nothing is given. Throws InputError for standard input, which has
/// no name; `option` is the one that would give a folder.
std::filesystem::path results_folder(const ProjectChoice& project, const std::filesystem::path& given,
                                     const std::string& option);

/// Cuts, meshes and computes the project, whose `text` was read, and says how far it is; Ctrl-C ends the run after its
/// step. A faulty project leaves the results folder as it was. Throws InputError.
RunReport solve_project(const ProjectChoice& project, const std::string& text, const RunChoice& choice);

/// Whether the run came to its end and met all that was expected of it.
bool all_met(const RunReport& report);

}  // namespace talus::cli
