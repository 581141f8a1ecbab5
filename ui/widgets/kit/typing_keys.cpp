#include "widgets/kit/typing_keys.hpp"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>

namespace talus {

namespace {

bool isField(const QObject* watched) {
  return qobject_cast<const QLineEdit*>(watched) || qobject_cast<const QAbstractSpinBox*>(watched) ||
         qobject_cast<const QComboBox*>(watched) || qobject_cast<const QPlainTextEdit*>(watched) ||
         qobject_cast<const QTextEdit*>(watched);
}

/// Nothing was typed that is not the project's yet: undo and redo are the project's.
bool undoesTheProject(const QObject* watched, const QKeyEvent& key) {
  const auto* field = qobject_cast<const QLineEdit*>(watched);
  return field && !field->isModified() && !field->property("state").isValid() &&
         (key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo));
}

bool isFunctionKey(int key) { return key >= Qt::Key_F1 && key <= Qt::Key_F35; }

}  // namespace

bool TypingKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && isField(watched)) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (undoesTheProject(watched, *key)) {
      event->ignore();
      return true;
    }
    const bool command = key->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier);
    if (!command && !isFunctionKey(key->key())) {
      event->accept();
      return true;
    }
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace talus
