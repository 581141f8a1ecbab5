#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <filesystem>

#include "document/selection.hpp"
#include "model/project.hpp"

namespace talus {

/// The project that is open: its values, where it is saved, what can be undone, what is selected. Every change goes
/// through a command on the undo stack; widgets listen to `projectChanged`.
class Document : public QObject {
  Q_OBJECT
 public:
  explicit Document(QObject* parent = nullptr);

  bool isOpen() const { return open_; }
  const Project& project() const { return project_; }
  /// The project's name, or the file's where it has none.
  QString name() const;
  /// Empty for a project that came out of a results folder.
  const std::filesystem::path& file() const { return file_; }
  /// What paths in the project are relative to.
  std::filesystem::path folder() const;
  /// NAME.results beside the project file.
  std::filesystem::path resultsFolder() const;
  bool isSaved() const { return undoStack_.isClean(); }

  QUndoStack& undoStack() { return undoStack_; }
  Selection& selection() { return selection_; }

  /// Opens a project file. Throws InputError; what was open before stays then.
  void open(const std::filesystem::path& file);
  /// Shows the project that results were computed from; it has no file of its own.
  void show(Project project);
  /// Writes to `file()`. Throws InputError.
  void save();
  void saveAs(const std::filesystem::path& file);

  /// One undoable change each. The changed project must pass the checks of a project file: throws InputError, and
  /// changes nothing, for what is impossible (a negative density).
  void changeMaterial(int index, const Material& changed);
  void changeJoint(int index, const Joint& changed);
  void changeSolid(int index, const Solid& changed);
  /// The whole project; `what` says it in the undo list: "use affine · Δ/2".
  void changeProject(const Project& changed, const QString& what);

 signals:
  void opened();
  void projectChanged();
  void savedChanged();

 private:
  template <class Thing>
  friend class ChangeItem;
  friend class ChangeProject;

  template <class Thing>
  void changeItem(std::vector<Thing> Project::*list, int index, const Thing& changed, const QString& what);
  void replace(Project project, std::filesystem::path file);

  Project project_;
  std::filesystem::path file_;
  bool open_ = false;
  QUndoStack undoStack_;
  Selection selection_;
};

}  // namespace talus
