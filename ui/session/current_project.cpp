#include "session/current_project.hpp"

#include "base/error.hpp"
#include "geometry/block_builder.hpp"
#include "session/messages.hpp"
#include "study/accuracy/study_record.hpp"

namespace talus {

CurrentProject::CurrentProject(Messages& messages) : messages_(messages) {}

CurrentProject::~CurrentProject() = default;

void CurrentProject::save() { saveAs(document_.file()); }

bool CurrentProject::saveAs(const std::filesystem::path& file) {
  try {
    document_.saveAs(file);
    messages_.log(tr("saved %1").arg(QString::fromStdString(file.string())));
    lookForStudy();
    return true;
  } catch (const InputError& error) {
    messages_.add(problemOf(error));
    return false;
  }
}

bool CurrentProject::systemIsCurrent() const { return system_ && build_alike(builtFrom_, document_.project()); }

QString CurrentProject::blockName(int block) const {
  if (!system_ || block < 0 || block >= static_cast<int>(system_->blocks.size())) return {};
  return QString::fromStdString(system_->blocks[static_cast<size_t>(block)].name);
}

void CurrentProject::setSystem(std::shared_ptr<const BlockSystem> system) {
  if (system == system_) return;
  if (selection().current().kind == Item::Kind::block) selection().clear();
  selection().hoverBlock(std::nullopt);
  system_ = std::move(system);
  emit systemChanged();
}

void CurrentProject::lookForStudy() {
  const auto folder = document_.file().empty() ? std::filesystem::path() : study_folder_of(document_.file());
  std::error_code none;
  const auto written = std::filesystem::last_write_time(folder / "accuracy.json", none);
  if (folder == studyFolder_ && written == studyWritten_) return;
  studyFolder_ = folder;
  studyWritten_ = written;
  study_.reset();
  try {
    if (!none)
      if (auto found = read_study(folder)) study_ = std::make_unique<StudyRecord>(std::move(*found));
  } catch (const InputError& error) {
    messages_.add(problemOf(error, Problem::Severity::warning));
  }
  emit studyChanged();
}

void CurrentProject::useSetting(const StudyRecord& record, int run) {
  const AccuracyRow& row = record.study.rows[static_cast<std::size_t>(run)];
  const QString label = QString::fromStdString(row.label);
  try {
    document_.changeProject(under(row.setting, *record.project), tr("use %1").arg(label));
    messages_.log(tr("the project has the setting %1").arg(label));
  } catch (const InputError& error) {
    messages_.add(problemOf(error, Problem::Severity::warning));
  }
}

}  // namespace talus
