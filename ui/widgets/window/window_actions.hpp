#pragma once

#include <QAction>
#include <QObject>
#include <map>
#include <utility>
#include <vector>

#include "session/workflow_page.hpp"
#include "widgets/results/data_export.hpp"

class QMenu;
class QMenuBar;

namespace talus {

struct Session;

class BlockActions;
class JointActions;
class LoadActions;
class SolidTools;
class Timeline;
class Viewport;

/// Everything that can be done in the window, once: menus, buttons, shortcuts and the command search share these.
/// A disabled one says why in its tooltip.
class WindowActions : public QObject {
  Q_OBJECT
 public:
  WindowActions(Session& session, QWidget& window);

  // File
  QAction *newProject, *open, *openResults, *save, *saveAs, *savePicture, *saveFilm, *saveReport, *compare, *startPage,
      *quit;
  QAction *saveView, *openView;
  // Edit
  QAction *undo, *redo, *clearSelection;
  // View
  QAction *fit, *iso, *front, *side, *top, *projection, *hide, *isolate, *showAll, *explode, *section, *showJoints,
      *showActions, *dark, *viewAlone;
  JointActions* joints;
  BlockActions* blocks;
  // Model and solve
  QAction *stereonet, *pasteJoints;
  QAction *mesh, *solve, *goOn, *pause, *oneStep, *stop;
  // Results
  std::vector<std::pair<DataFormat, QAction*>> exports;
  QAction *play, *previousFrame, *nextFrame, *firstFrame, *lastFrame, *accuracy;
  QAction *manual, *knownAnswers, *hardCases, *about;
  std::map<WorkflowPage, QAction*> pages;
  LoadActions* loads;
  SolidTools* solids;  ///< and their actions

  /// Connects what only the view and the timeline can do.
  void drive(Viewport& viewport, Timeline& timeline);
  void fill(QMenuBar& bar, QMenu* recent);
  /// In the menus' order.
  const std::vector<QAction*>& all() const { return all_; }

 private:
  QAction* add(const QString& text, const QString& icon, const QKeySequence& shortcut = {});
  /// An action that another class has made becomes one of all.
  void include(QAction* action);
  void makeFileActions();
  void makeViewActions();
  void makeRunActions();
  void refresh();

  Session& session_;
  QWidget& window_;
  std::vector<QAction*> all_;
};

}  // namespace talus
