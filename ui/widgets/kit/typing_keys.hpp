#pragma once

#include <QObject>

namespace talus {

/// What is typed into a field is the field's: its keys, Escape among them, are no shortcuts of the window meanwhile.
/// Those with Ctrl or Alt and the function keys still are; undo and redo, once what was typed is in the project.
/// Install it on the application.
class TypingKeys : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace talus
