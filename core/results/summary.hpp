#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/run_report.hpp"

namespace talus {

/// summary.json's text, also what `--json` prints: an object on several lines. Numbers that are not finite, and what
/// was computed for an expectation the run did not reach, are null.
std::string summary_json(const RunReport& report);

/// The events of a summary.json; none when there is no such file or it cannot be understood.
std::vector<Event> read_events(const std::filesystem::path& file);

}  // namespace talus
