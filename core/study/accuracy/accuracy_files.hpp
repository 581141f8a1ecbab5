#pragma once

#include <string>

#include "study/accuracy/accuracy.hpp"

namespace talus {

/// accuracy.csv: a row a run, in the order of the plan. docs/accuracy.md has the columns.
std::string accuracy_csv(const AccuracyStudy& study);

/// accuracy.json: the same, with orders, reference, target, recommendation and what each run's effects and phases took.
/// docs/accuracy.md has the fields.
std::string accuracy_json(const AccuracyStudy& study);

/// The project under the recommended setting, as the text of a project file; paths in it are relative to `folder`.
std::string recommended_project(const AccuracyStudy& study, const StudyPlan& plan, const std::filesystem::path& folder);

/// accuracy.csv, accuracy.json and, where there is a recommendation, recommended.talus in the study's folder.
void write_accuracy_files(const AccuracyStudy& study, const StudyFolder& folder);

}  // namespace talus
