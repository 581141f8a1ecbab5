// The accuracy study of the project in the workspace.
#include "base/error.hpp"
#include "widgets/workspace.hpp"

namespace talus {

namespace {

Problem problemOf(const InputError& error) {
  return {Problem::Severity::warning, QString::fromStdString(error.place()), QString::fromStdString(error.problem()),
          QString::fromStdString(error.remedy())};
}

}  // namespace

void Workspace::lookForStudy() {
  const auto folder = document_.file().empty() ? std::filesystem::path() : study_folder_of(document_.file());
  std::error_code none;
  const auto written = std::filesystem::last_write_time(folder / "accuracy.json", none);
  if (folder == studyFolder_ && written == studyWritten_) return;
  studyFolder_ = folder;
  studyWritten_ = written;
  study_.reset();
  try {
    if (!none) study_ = read_study(folder);
  } catch (const InputError& error) {
    addProblem(problemOf(error));
  }
  emit studyChanged();
}

void Workspace::useSetting(const StudyRecord& record, int run) {
  const AccuracyRow& row = record.study.rows[static_cast<std::size_t>(run)];
  const QString label = QString::fromStdString(row.label);
  try {
    document_.changeProject(under(row.setting, *record.project), tr("use %1").arg(label));
    log(tr("the project has the setting %1").arg(label));
  } catch (const InputError& error) {
    addProblem(problemOf(error));
  }
}

}  // namespace talus
