#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "measures/block_travel.hpp"
#include "model/project.hpp"
#include "results/result_folder.hpp"

/// What is known of a run, gathered once for all sections of its report.
namespace talus::report {

/// The project as it was run, or why it is not known.
struct ProjectOfRun {
  std::optional<Project> project;
  std::string why_not;
};

struct RunRecord {
  /// Throws InputError where the folder holds no results, or no frame yet.
  RunRecord(const std::filesystem::path& folder, ProjectOfRun kept);

  const BlockSystem& system() const { return results.system(); }

  ResultReader results;
  std::optional<RunReport> report;  ///< none of a run that goes on or was killed
  std::optional<Project> project;
  std::string why_no_project;
  std::vector<StepReport> steps;
  std::vector<HistoryRow> history;
  Frame last;
  std::vector<BlockTravel> travels;  ///< of the blocks that are not built fixed, the farthest first
};

/// J, the most that an account of the ledger came to: what remainder and losses are held to.
double energy_moved(const std::vector<StepReport>& steps);

}  // namespace talus::report
