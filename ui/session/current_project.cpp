#include "session/current_project.hpp"

#include "base/error.hpp"
#include "document/brought_files.hpp"
#include "geometry/block_builder.hpp"
#include "io/project_file.hpp"
#include "session/messages.hpp"
#include "session/solid_file.hpp"
#include "study/accuracy/study_record.hpp"

namespace talus {

CurrentProject::CurrentProject(Messages& messages) : messages_(messages) {}

CurrentProject::~CurrentProject() = default;

void CurrentProject::save() { saveAs(document_.file()); }

bool CurrentProject::saveAs(const std::filesystem::path& file) {
  try {
    document_.saveAs(file);
    messages_.settle(Problem::Of::file);
    messages_.log(tr("saved %1").arg(QString::fromStdString(file.string())));
    lookForStudy();
    return true;
  } catch (const InputError& error) {
    messages_.settle(Problem::Of::file);
    messages_.add(problemIn(file, error));
    return false;
  }
}

void CurrentProject::addSolid(const Solid& solid, const std::filesystem::path& file,
                              const std::optional<Vec3>& origin) {
  const auto source = std::filesystem::absolute(file);
  const bool hasPlace = !document_.folder().empty();
  const auto folder = hasPlace ? document_.folder() : source.parent_path(), copy = folder / file.filename();
  const auto seen = source.lexically_relative(folder);
  const bool isBeside = !seen.empty() && *seen.begin() != "..";
  Project changed = with_solid(document_.project(), solid, isBeside ? source : copy, folder);
  if (origin) changed.origin = *origin;
  parse_project(write_project(changed), {.unfinished = true});  // before anything is copied
  if (!isBeside) {
    if (document_.file().empty())
      throw InputError(file.string(), "cannot be copied beside a project that has no place yet",
                       "save the project, and import the file again");
    bring_file(source, copy);
    messages_.log(tr("copied %1 beside the project").arg(QString::fromStdString(file.string())));
  }
  if (!hasPlace) document_.settleIn(folder);
  document_.change(changed, tr("add solid %1").arg(QString::fromStdString(changed.solids.back().name)));
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

void CurrentProject::beginBuilding(bool anew) {
  earlier_ = system_;
  earlierFrom_ = builtFrom_;
  builtFrom_ = document_.project();
  if (anew) setSystem(nullptr);
}

void CurrentProject::abandonBuilding() {
  if (system_ || !earlier_) return;
  builtFrom_ = earlierFrom_;
  setSystem(std::move(earlier_));
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
    document_.change(under(row.setting, *record.project), tr("use %1").arg(label));
    messages_.log(tr("the project has the setting %1").arg(label));
  } catch (const InputError& error) {
    messages_.add(problemOf(error, Problem::Severity::warning));
  }
}

}  // namespace talus
