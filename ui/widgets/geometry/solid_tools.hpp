#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <vector>

#include "widgets/geometry/move_dialog.hpp"
#include "widgets/geometry/new_solids.hpp"

class QAction;
class QMenu;

namespace talus {

class MeasureCard;
class SectionEditor;
struct Session;

/// What can be done with solids: brought from files, made, moved, combined, measured. These are actions of the window,
/// which lists them in its menus, strips and search; a disabled one says why in its tooltip.
class SolidTools : public QObject {
  Q_OBJECT
 public:
  SolidTools(Session& session, QWidget& window);

  QAction *importGeometry, *newBox, *newBench, *newPolyhedron, *newTunnel;
  QAction *move, *turn, *scale, *copy, *unite, *subtract, *intersect, *section;
  QAction* measure;

  /// In the order of the menus.
  const std::vector<QAction*>& all() const { return all_; }
  /// Fill a menu with those that make a solid, or change what is selected.
  void addNew(QMenu& menu) const;
  void addChanges(QMenu& menu) const;
  /// Asks how a file is to be understood; a project is begun where none is open.
  void importFile(const std::filesystem::path& file);
  /// The view in which is measured.
  void measureIn(QWidget& view) { view_ = &view; }

 signals:
  /// No project is open that a file could be imported into: one is to be begun beside it.
  void projectWanted(const std::filesystem::path& file);

 private:
  QAction* add(const QString& text, const char* icon, const QString& shortcut, const std::function<void()>& act);
  void makeActions();
  void refresh();
  void askForFile();
  void makeNew(NewShape shape, const QString& what);
  void combine(CombineOperation operation, const QString& what);
  void openSection();
  void openMove(MoveDialog::Kind kind);
  void openMeasure();

  Session& session_;
  QWidget& window_;
  QWidget* view_ = nullptr;
  std::vector<QAction*> all_;
  SectionEditor* editor_ = nullptr;     ///< once it has been asked for
  MeasureCard* measureCard_ = nullptr;  ///< likewise
};

}  // namespace talus
