#pragma once

#include <QFrame>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>

#include "widgets/window_actions.hpp"

namespace talus {

/// The step's name, its actions with words, one line of outcome, and the one primary button that leads on.
class StepBar : public QFrame {
  Q_OBJECT
 public:
  StepBar(Workspace& workspace, WindowActions& actions);

 private:
  QWidget* makeSetUpPage();
  QWidget* makeSolvePage();
  QWidget* makeResultsPage();
  void refresh();
  void refreshOutcome();
  void refreshPrimary();
  QString outcome() const;
  QString runOutcome() const;
  QAction* primaryAction() const;

  Workspace& workspace_;
  WindowActions& actions_;
  QLabel *title_, *outcome_;
  QStackedWidget* pages_;
  QProgressBar* bar_;
  QPushButton* primary_;
};

}  // namespace talus
