#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "study/accuracy/study_run.hpp"

namespace talus {

/// The file of a run; numbers as they are, so that they are read back bit for bit.
std::string study_run_text(const StudyRun& run);

/// Nothing where there is no such file. Throws InputError where it cannot be understood. Of expectations only the
/// numbers are there.
std::optional<StudyRun> read_study_run(const std::filesystem::path& file);

/// What the file of a run and a row of accuracy.json both have: status, cost, counts, phases and effects. Throws
/// nlohmann::json::exception for what is no run.
StudyRun run_figures_of(const nlohmann::ordered_json& json);

/// As summary.json has them.
nlohmann::ordered_json phases_json(const Phases& phases);
nlohmann::ordered_json effects_json(const std::vector<EffectOutcome>& effects);

}  // namespace talus
