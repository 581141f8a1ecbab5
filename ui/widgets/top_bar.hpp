#pragma once

#include <QCompleter>
#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>

#include "widgets/window_actions.hpp"

namespace talus {

/// Menus, the project's name and whether it is saved, undo and redo, command search, theme.
class TopBar : public QFrame {
  Q_OBJECT
 public:
  TopBar(Workspace& workspace, WindowActions& actions);
  QMenu* recentMenu() { return recent_; }
  void focusSearch();

 private:
  void refresh();
  void runCommand(const QString& name);
  QLineEdit* makeSearch();

  Workspace& workspace_;
  WindowActions& actions_;
  QMenu* recent_;
  QLabel *name_, *saved_;
  QLineEdit* search_;
  QToolButton* theme_;
};

/// A tool button for an action: its icon, state and tooltip, and a word where `worded`.
QToolButton* makeActionButton(QAction* action, bool worded);

}  // namespace talus
