#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "study/accuracy/accuracy.hpp"

namespace talus {

/// A study that was made, as it lies on disk, and the project that it was made of.
struct StudyRecord {
  std::filesystem::path place;     ///< its folder, or the accuracy.json that is all that there is
  std::optional<Project> project;  ///< none where there is no folder
  AccuracyStudy study;
};

/// NAME.accuracy beside the project NAME.talus: where a study lies unless it was told otherwise.
std::filesystem::path study_folder_of(const std::filesystem::path& project_file);

/// With the cheapest run within `target`. Nothing without an accuracy.json. Throws InputError for files it cannot read.
std::optional<StudyRecord> read_study(const std::filesystem::path& folder, std::optional<double> target = {});

/// Of an accuracy.json: the study that it lies in, or itself alone, from another machine. Throws InputError.
StudyRecord read_accuracy_file(const std::filesystem::path& file);

/// The run that was made of just this project: whose setting it has. Nothing where the study knows none.
std::optional<int> run_of(const StudyRecord& record, const Project& project);

/// The error that the study found of the run that was made of just this project, relative. Nothing where it knows none.
std::optional<double> error_of(const StudyRecord& record, const Project& project);

/// The runs that are best for their cost, the cheapest first.
std::vector<int> best_by_cost(const AccuracyStudy& study);

}  // namespace talus
