#pragma once

#include <QFrame>

#include "widgets/window/window_actions.hpp"

class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace talus {

struct Session;

/// The page's name, its actions with words, one line of outcome, and the one primary button that leads on.
class WorkflowBar : public QFrame {
  Q_OBJECT
 public:
  WorkflowBar(Session& session, WindowActions& actions);

 private:
  QWidget* makeSetUpPage(WorkflowPage page);
  void addGeometryActions(QHBoxLayout& row);
  void addJointActions(QHBoxLayout& row);
  void addLoadActions(QHBoxLayout& row);
  QWidget* makeSolvePage();
  QWidget* makeResultsPage();
  void showWithField(QWidget& box);
  void refresh();
  void refreshOutcome();
  void refreshPrimary();
  QString outcome() const;
  QString solidsOutcome() const;
  /// What is said of blocks, and whether they are those of the project as it is.
  QString ofBlocks(const QString& words) const;
  QString runOutcome() const;
  /// With the time left, where that is worth a word.
  QString cuttingOutcome() const;
  QAction* primaryAction() const;

  Session& session_;
  WindowActions& actions_;
  QLabel *title_, *outcome_;
  QStackedWidget* pages_;
  QProgressBar* bar_;
  QPushButton* primary_;
};

}  // namespace talus
