#include "document/document.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "document/brought_files.hpp"
#include "document/content.hpp"
#include "document/item_place.hpp"
#include "document/text_change.hpp"
#include "io/project_file.hpp"
#include "io/whole_file.hpp"

namespace talus {

namespace {

constexpr ReadOptions setting_up{.unfinished = true};

}  // namespace

Document::Document(QObject* parent) : QObject(parent), content_(std::make_unique<Content>()) {
  connect(&undoStack_, &QUndoStack::cleanChanged, this, &Document::savedChanged);
}

Document::~Document() {
  undoStack_.disconnect();  // as it goes it says that it is clean, to those who look at what is gone already
}

const Project& Document::project() const { return content_->project; }

const std::string& Document::text() const { return content_->text; }

const Document::Json& Document::json() const { return content_->json; }

QString Document::name() const {
  return QString::fromStdString(project().name.empty() ? file_.stem().string() : project().name);
}

std::filesystem::path Document::folder() const {
  return file_.empty() ? origin_ : std::filesystem::absolute(file_).parent_path();
}

std::filesystem::path Document::resultsFolder() const { return folder() / (file_.stem().string() + ".results"); }

void Document::open(const std::filesystem::path& file) {
  read_project(file, setting_up);  // its errors say that they are a file's; links must not lead out of its folder
  replace(read(read_whole_file(file)), {.file = std::filesystem::absolute(file), .isWork = false});
}

void Document::begin(const Draft& draft) { replace(read(draft.text), draft); }

void Document::show(const Project& project, const std::filesystem::path& folder) {
  begin({.text = write_project(project), .folder = folder, .isWork = false});
}

void Document::save() { saveAs(file_); }

void Document::saveAs(const std::filesystem::path& file) {
  const auto target = std::filesystem::absolute(file);
  bring_files(project(), folder(), target.parent_path());
  replace_whole_file(target, text());
  file_ = target;
  isUnsavedWork_ = false;
  undoStack_.setClean();
  emit savedChanged();
}

void Document::change(const Project& changed, const QString& what, int gesture) {
  changeText(write_project(changed, text()), what, gesture);
}

void Document::change(const Json& changed, const QString& what, int gesture) {
  changeText(change_project_text(text(), changed.dump()), what, gesture);
}

/// The same checks that a file is read with: what the window lets through can be opened again.
std::unique_ptr<Document::Content> Document::read(std::string text) {
  auto content = std::make_unique<Content>();
  content->project = parse_project(text, setting_up);
  content->json = Json::parse(text, nullptr, true, true);
  content->text = std::move(text);
  return content;
}

void Document::changeText(std::string text, const QString& what, int gesture) {
  if (text != content_->text) undoStack_.push(new TextChange(*this, read(std::move(text)), what, gesture));
}

void Document::put(std::unique_ptr<Content> content) {
  content_ = std::move(content);
  const auto isGone = [this](int solid) { return solid >= static_cast<int>(project().solids.size()); };
  if (!exists(selection_.current(), json()) || std::ranges::any_of(selection_.solids(), isGone)) selection_.clear();
  emit projectChanged();
}

void Document::replace(std::unique_ptr<Content> content, const Draft& place) {
  undoStack_.clear();
  selection_.clear();
  content_ = std::move(content);
  file_ = place.file;
  origin_ = place.folder;
  isUnsavedWork_ = place.isWork;
  open_ = true;
  emit opened();
  emit savedChanged();
}

}  // namespace talus
