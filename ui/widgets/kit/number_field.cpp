#include "widgets/kit/number_field.hpp"

#include <QKeyEvent>
#include <QStyle>
#include <QTimer>

#include "widgets/kit/numbers.hpp"

namespace talus {

NumberField::NumberField(std::optional<double> value, double scale, const QString& unit)
    : value_(value), scale_(scale), unit_(unit) {
  setAlignment(Qt::AlignRight);
  setMinimumWidth(66);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  connect(this, &QLineEdit::editingFinished, this, &NumberField::commit);
  show();
}

void NumberField::allowNone(const QString& meaning) {
  mayBeEmpty_ = true;
  setPlaceholderText(meaning);
}

void NumberField::show() {
  if (!value_) return clear();
  const QString number = QString::number(*value_ / scale_, 'g', 12).replace(u'-', QChar(0x2212));
  setText(unit_.isEmpty() ? number : number + u' ' + unit_);
}

void NumberField::setProblem(const QString& sentence) {
  setProperty("state", sentence.isEmpty() ? QVariant() : QVariant("error"));
  setToolTip(sentence);
  style()->unpolish(this);
  style()->polish(this);
}

void NumberField::commit() {
  if (!isModified()) return;
  setModified(false);
  QString typed = text();
  if (!unit_.isEmpty() && typed.endsWith(unit_)) typed.chop(unit_.size());
  if (mayBeEmpty_ && typed.trimmed().isEmpty()) {
    setProblem({});
    if (value_) emit cleared();
    return;
  }
  double number = 0;
  if (!numbers::parse(typed, number)) {
    setProblem(tr("This is not a number"));
    return;
  }
  setProblem({});
  if (number * scale_ == value_) {
    show();
    return;
  }
  emit committed(number * scale_);
}

void NumberField::focusInEvent(QFocusEvent* event) {
  QLineEdit::focusInEvent(event);
  QTimer::singleShot(0, this, &QLineEdit::selectAll);  // after the click has placed the cursor
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    setModified(false);
    setProblem({});
    show();
    return;
  }
  QLineEdit::keyPressEvent(event);
}

}  // namespace talus
