#pragma once

#include <QLineEdit>
#include <QPointer>
#include <functional>
#include <vector>

namespace talus {

/// Something that can be done in the window, by the words of its menu entry or button.
struct Command {
  QString words, key;  ///< "Save picture…" without the dots; its shortcut, which may be empty
  bool isPossible = true;
  QString why;  ///< the whole tooltip: what it does, or why it cannot be done now
  std::function<void()> run;
};

/// All entries of menus, and the buttons of the window that are to be seen; fields of forms and what belongs to each of
/// them are found in the form. An entry of a menu with a title has it before its words: "Stress: kPa".
std::vector<Command> commandsOf(const QWidget& window);

/// The entry that finds commands by their words: Return does the first one that fits.
class CommandSearch : public QLineEdit {
  Q_OBJECT
 public:
  CommandSearch();
  /// Takes the keyboard, and looks at what can be done now.
  void begin();

 private:
  void run(const QString& line);

  std::vector<Command> commands_;
};

}  // namespace talus
