#include "study/accuracy/study_record.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "study/accuracy/accuracy_reader.hpp"

namespace talus {

namespace {

/// False too where the project cannot have the setting.
bool is_under(const Setting& setting, const Project& studied, const Project& project) {
  try {
    return under(setting, studied) == project;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

std::filesystem::path study_folder_of(const std::filesystem::path& project_file) {
  return std::filesystem::path(project_file).replace_extension(".accuracy");
}

std::optional<StudyRecord> read_study(const std::filesystem::path& folder, std::optional<double> target) {
  std::error_code unreadable;  // as if there were none
  if (!std::filesystem::exists(folder / "accuracy.json", unreadable)) return std::nullopt;
  const StudyFolder files(folder);
  return StudyRecord{files.path(), project_of(files.plan()), evaluate(files, target)};
}

StudyRecord read_accuracy_file(const std::filesystem::path& file) {
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  if (file.filename() == "accuracy.json" && std::filesystem::exists(folder / "study.json")) return *read_study(folder);
  return {std::filesystem::absolute(file), std::nullopt, read_accuracy_json(file)};
}

std::optional<int> run_of(const StudyRecord& record, const Project& project) {
  if (!record.project) return std::nullopt;
  for (std::size_t i = 0; i < record.study.rows.size(); ++i)
    if (is_under(record.study.rows[i].setting, *record.project, project)) return static_cast<int>(i);
  return std::nullopt;
}

std::optional<double> error_of(const StudyRecord& record, const Project& project) {
  const auto run = run_of(record, project);
  return run ? record.study.rows[static_cast<std::size_t>(*run)].error : std::nullopt;
}

std::vector<int> best_by_cost(const AccuracyStudy& study) {
  std::vector<int> best;
  for (std::size_t i = 0; i < study.rows.size(); ++i)
    if (study.rows[i].pareto) best.push_back(static_cast<int>(i));
  const auto seconds = [&](int run) { return study.rows[static_cast<std::size_t>(run)].run->cpu_seconds; };
  std::stable_sort(best.begin(), best.end(), [&](int a, int b) { return seconds(a) < seconds(b); });
  return best;
}

}  // namespace talus
