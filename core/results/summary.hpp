#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "results/run_report.hpp"

namespace talus {

/// summary.json's text, also what `--json` prints: an object on several lines. Numbers that are not finite, and what
/// was computed for an expectation the run did not reach, are null.
std::string summary_json(const RunReport& report);

/// What a summary.json says of the run as a whole: how it ended, what its effects were and cost, its work, where it was
/// hard and its events. Blocks, the last step, penetrations and expectations stay as they are in an empty report. What
/// the file does not hold (an older Talus wrote it) is zero. None when there is no such file or it cannot be
/// understood.
std::optional<RunReport> read_summary(const std::filesystem::path& file);

}  // namespace talus
