#pragma once

#include <QFrame>

#include "widgets/window/window_actions.hpp"

class QLabel;
class QMenu;
class QToolButton;

namespace talus {

class CommandSearch;
class Display;
class Document;

/// Menus, the project's name and whether it is saved, undo and redo, command search, theme.
class TopBar : public QFrame {
  Q_OBJECT
 public:
  TopBar(Document& document, Display& display, WindowActions& actions);
  QMenu* recentMenu() { return recent_; }
  CommandSearch& search() { return *search_; }

 private:
  void refresh();

  Document& document_;
  Display& display_;
  WindowActions& actions_;
  QMenu* recent_;
  QLabel *name_, *saved_;
  CommandSearch* search_;
  QToolButton* theme_;
};

/// A tool button for an action: its icon, state and tooltip, and a word where `worded`.
QToolButton* makeActionButton(QAction* action, bool worded);

}  // namespace talus
