#include "widgets/kit/number_field.hpp"

#include <QKeyEvent>
#include <QPointer>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QTimer>
#include <utility>

#include "base/error.hpp"
#include "base/quantity_text.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

NumberField::NumberField(std::optional<double> value, Units units) : value_(value), units_(std::move(units)) {
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

void NumberField::setMeaning(const QString& sentence) {
  meaning_ = sentence;
  setToolTip(sentence);
}

void NumberField::setValue(std::optional<double> value) {
  value_ = value;
  setProblem({});
  show();
}

void NumberField::show() {
  if (!value_) return clear();
  const QString whole = written(numbers::all_figures), shown = hasFocus() ? whole : fitting();
  setText(shown);
  setCursorPosition(0);
  const QString meaning = meaning_.isEmpty() && parentWidget() ? parentWidget()->toolTip() : meaning_;
  setToolTip(shown == whole ? meaning_ : QStringList{whole, meaning}.join(u'\n').trimmed());
}

QString NumberField::written(int figures) const {
  const double shown = converted(*value_, units_.kept.toStdString(), units_.shown.toStdString());
  const QString number = numbers::inField(shown, figures);
  return units_.behind && !units_.shown.isEmpty() ? number + u' ' + units_.shown : number;
}

/// A number is rounded before its unit is cut off; who types into the field sees all of it.
QString NumberField::fitting() const {
  constexpr int fewest = 3, beside_text = 4;  // figures; pixels that a line edit leaves at its sides
  QStyleOptionFrame option;
  initStyleOption(&option);
  const int room = style()->subElementRect(QStyle::SE_LineEditContents, &option, this).width() - beside_text;
  for (int figures = numbers::all_figures; figures >= fewest; --figures)
    if (const QString words = written(figures); fontMetrics().horizontalAdvance(words) <= room) return words;
  return written(fewest);
}

/// Shows the number anew as it fits, unless something is being typed, or was refused.
void NumberField::fitAnew() {
  if (!isModified() && !property("state").isValid()) show();
}

void NumberField::resizeEvent(QResizeEvent* event) {
  QLineEdit::resizeEvent(event);
  if (!hasFocus()) fitAnew();
}

void NumberField::setProblem(const QString& sentence) {
  setProperty("state", sentence.isEmpty() ? QVariant() : QVariant("error"));
  setToolTip(sentence.isEmpty() ? meaning_ : sentence);
  style()->unpolish(this);
  style()->polish(this);
  emit problemChanged(sentence);
}

void NumberField::commit() {
  if (!isModified()) return;
  setModified(false);
  if (mayBeEmpty_ && QLineEdit::text().trimmed().isEmpty()) {
    setProblem({});
    if (value_) emit cleared();
    return;
  }
  try {
    const double number =
        read_quantity(QLineEdit::text().toStdString(), units_.kept.toStdString(), units_.shown.toStdString());
    setProblem({});
    if (number == value_) return show();
    const QPointer<NumberField> stays(this);  // a form may be made anew for another number
    const auto before = std::exchange(value_, number);
    emit committed(number);
    if (!stays) return;
    if (property("state").isValid())
      value_ = before;  // it was refused: Escape goes back there
    else
      show();
  } catch (const InputError& error) {
    setProblem(QObject::tr("%1; %2").arg(talus::text(error.problem()), talus::text(error.remedy())));
  }
}

bool NumberField::event(QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return QLineEdit::event(event);
  auto* keys = static_cast<QKeyEvent*>(event);
  const bool typedIn = isModified() || property("state").isValid();
  // Escape takes back what was typed, and nothing else in the window.
  if (keys->key() == Qt::Key_Escape && typedIn) {
    event->accept();
    return true;
  }
  return QLineEdit::event(event);
}

void NumberField::focusInEvent(QFocusEvent* event) {
  QLineEdit::focusInEvent(event);
  fitAnew();
  QTimer::singleShot(0, this, [this] {  // after the click has placed the cursor
    if (hasFocus()) selectAll();
  });
}

void NumberField::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  fitAnew();
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    setModified(false);
    setProblem({});
    show();
    emit takenBack();
    return;
  }
  QLineEdit::keyPressEvent(event);
}

}  // namespace talus
