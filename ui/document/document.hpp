#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>

#include "document/selection.hpp"
#include "model/project.hpp"

namespace talus {

/// A project as it is before it has been saved: made new, a copy of a sample, or recovered.
struct Draft {
  std::string text{};              ///< of a project file
  std::filesystem::path file{};    ///< where it was saved last; empty: nowhere yet
  std::filesystem::path folder{};  ///< what its paths are relative to while it has no file
  bool isWork = true;              ///< there is something in it that would be lost
};

/// The project that is open: its values, where it is saved, what can be undone, what is selected. It keeps the text of
/// the project file, with the comments in it, and what that means; every change goes through `change`, and widgets
/// listen to `projectChanged`. A project that is still being set up may lack solids, stages and the default joint.
class Document : public QObject {
  Q_OBJECT
 public:
  using Json = nlohmann::ordered_json;

  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  bool isOpen() const { return open_; }
  const Project& project() const;
  /// What the file would hold if it were saved now.
  const std::string& text() const;
  /// What the text says, key by key: what it leaves out is not there.
  const Json& json() const;
  /// The project's name, or the file's where it has none.
  QString name() const;
  /// Empty for a project that came out of a results folder, and for one that was never saved.
  const std::filesystem::path& file() const { return file_; }
  /// What paths in the project are relative to.
  std::filesystem::path folder() const;
  /// A project that has no place yet: its paths are relative to this folder from now on, until it is saved.
  void settleIn(const std::filesystem::path& folder) { origin_ = folder; }
  /// NAME.results beside the project file.
  std::filesystem::path resultsFolder() const;
  /// Nothing would be lost if it were closed.
  bool isSaved() const { return undoStack_.isClean() && !isUnsavedWork_; }
  /// The project as it is now, to be begun again.
  Draft draft() const { return {text(), file_, folder(), !isSaved()}; }

  QUndoStack& undoStack() { return undoStack_; }
  Selection& selection() { return selection_; }

  /// Opens a project file. Throws InputError; what was open before stays then.
  void open(const std::filesystem::path& file);
  /// A project that is not in a file as it is. Throws InputError; what was open before stays then.
  void begin(const Draft& draft);
  /// Shows the project that results in `folder` were computed from: it has no file of its own.
  void show(const Project& project, const std::filesystem::path& folder = {});
  /// Writes to `file()`. Throws InputError.
  void save();
  /// Files that the project names beside it are copied along into another folder.
  void saveAs(const std::filesystem::path& file);

  /// The project becomes `changed`: one step that can be undone, called `what` in the undo list ("use affine · Δ/2").
  /// It must pass the checks of a project file: throws InputError, and changes nothing, for what is impossible (a
  /// negative density). Does nothing where nothing changes. Comments and layout of the text stay wherever it says the
  /// same. Changes that follow each other with the same `gesture`, a number from newGesture, are one step together: a
  /// handle that is dragged.
  void change(const Project& changed, const QString& what, int gesture = no_gesture);
  /// The same, said key by key.
  void change(const Json& changed, const QString& what, int gesture = no_gesture);
  int newGesture() { return ++gesture_; }

 signals:
  void opened();
  void projectChanged();
  void savedChanged();

 private:
  friend class TextChange;
  static constexpr int no_gesture = -1;
  struct Content;

  static std::unique_ptr<Content> read(std::string text);
  void changeText(std::string text, const QString& what, int gesture);
  void put(std::unique_ptr<Content> content);
  void replace(std::unique_ptr<Content> content, const Draft& place);

  std::unique_ptr<Content> content_;
  std::filesystem::path file_, origin_;  ///< where it is saved; what its paths are relative to until it is
  bool open_ = false;
  bool isUnsavedWork_ = false;  ///< what was begun is in no file
  int gesture_ = 0;
  QUndoStack undoStack_;
  Selection selection_;
};

}  // namespace talus
