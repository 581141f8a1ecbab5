#include "document/document.hpp"

#include "base/error.hpp"
#include "document/commands.hpp"
#include "io/project_file.hpp"

namespace talus {

namespace {

/// The same checks that a file is read with: what the window lets through can be opened again.
void check(const Project& project) { parse_project(write_project(project)); }

}  // namespace

Document::Document(QObject* parent) : QObject(parent) {
  connect(&undoStack_, &QUndoStack::cleanChanged, this, &Document::savedChanged);
}

QString Document::name() const {
  return QString::fromStdString(project_.name.empty() ? file_.stem().string() : project_.name);
}

std::filesystem::path Document::folder() const { return std::filesystem::absolute(file_).parent_path(); }

std::filesystem::path Document::resultsFolder() const { return folder() / (file_.stem().string() + ".results"); }

void Document::open(const std::filesystem::path& file) { replace(read_project(file), std::filesystem::absolute(file)); }

void Document::show(Project project) { replace(std::move(project), {}); }

void Document::save() { saveAs(file_); }

void Document::saveAs(const std::filesystem::path& file) {
  save_project(project_, file);
  file_ = std::filesystem::absolute(file);
  undoStack_.setClean();
  emit savedChanged();
}

template <class Thing>
void Document::changeItem(std::vector<Thing> Project::*list, int index, const Thing& changed, const QString& what) {
  Project candidate = project_;
  Thing& item = (candidate.*list).at(static_cast<size_t>(index));
  const QString name = QString::fromStdString(item.name);
  item = changed;
  check(candidate);
  undoStack_.push(new ChangeItem<Thing>(*this, list, index, changed, what.arg(name)));
}

void Document::changeMaterial(int index, const Material& changed) {
  changeItem(&Project::materials, index, changed, tr("change material %1"));
}

void Document::changeJoint(int index, const Joint& changed) {
  changeItem(&Project::joints, index, changed, tr("change joint %1"));
}

void Document::changeSolid(int index, const Solid& changed) {
  changeItem(&Project::solids, index, changed, tr("change solid %1"));
}

void Document::changeProject(const Project& changed, const QString& what) {
  check(changed);
  undoStack_.push(new ChangeProject(*this, changed, what));
}

void Document::replace(Project project, std::filesystem::path file) {
  undoStack_.clear();
  selection_.clear();
  project_ = std::move(project);
  file_ = std::move(file);
  open_ = true;
  emit opened();
  emit savedChanged();
}

}  // namespace talus
