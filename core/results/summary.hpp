#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "results/run_report.hpp"

namespace talus {

/// summary.json's text, also what `--json` prints: an object on several lines. Numbers that are not finite, and what
/// was computed for an expectation the run did not reach, are null.
std::string summary_json(const RunReport& report);

/// What a summary.json says of the run as a whole. Blocks stay out: where they are and how they move is in the last
/// frame; of the last step there are energies and contacts. What an older Talus did not write is zero or empty.
/// None when there is no such file or it cannot be understood.
std::optional<RunReport> read_summary(const std::filesystem::path& file);

}  // namespace talus
