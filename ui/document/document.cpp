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

void Document::changeMaterial(int index, const Material& changed) {
  Project candidate = project_;
  candidate.materials.at(static_cast<size_t>(index)) = changed;
  check(candidate);
  undoStack_.push(new ChangeMaterial(*this, index, changed));
}

void Document::changeJoint(int index, const Joint& changed) {
  Project candidate = project_;
  candidate.joints.at(static_cast<size_t>(index)) = changed;
  check(candidate);
  undoStack_.push(new ChangeJoint(*this, index, changed));
}

void Document::changeSolid(int index, const Solid& changed) {
  Project candidate = project_;
  candidate.solids.at(static_cast<size_t>(index)) = changed;
  check(candidate);
  undoStack_.push(new ChangeSolid(*this, index, changed));
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
