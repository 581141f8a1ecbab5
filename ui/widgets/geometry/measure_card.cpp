#include "widgets/geometry/measure_card.hpp"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QTimer>

#include "document/document.hpp"
#include "widgets/kit/parts.hpp"

namespace talus {

namespace {

constexpr int away = 12, below_prompt = 60;  // pixels from the view's corner; what is asked for stands above
constexpr int least_width = 264;             // surveyed coordinates take more

QString promptFor(Measured what) {
  switch (what) {
    case Measured::face:
      return MeasureCard::tr("Measure: click a face");
    case Measured::line:
      return MeasureCard::tr("Measure: click two points");
    case Measured::plane:
      break;
  }
  return MeasureCard::tr("Measure: click three points");
}

}  // namespace

MeasureCard::MeasureCard(Document& document, Picking& picking, QWidget* view)
    : QFrame(view), document_(document), picking_(picking) {
  setProperty("plane", "overlay");
  setObjectName(QStringLiteral("measure"));
  setMinimumWidth(least_width);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 8, 10);
  column->setSpacing(6);
  auto* head = new QHBoxLayout;
  what_ = makeCombo({tr("Face"), tr("Distance"), tr("Angle and plane")}, tr("What is measured"));
  what_->setCurrentIndex(static_cast<int>(Measured::line));
  copy_ = makeTool(QStringLiteral("copy"), tr("Copy what was measured"));
  auto* close = makeTool(QStringLiteral("close"), tr("End measuring (Esc)"));
  head->addWidget(what_, 1);
  head->addWidget(copy_);
  head->addWidget(close);
  column->addLayout(head);
  prompt_ = makeWrappedLabel({}, "small");
  column->addWidget(prompt_);
  facts_ = new QFormLayout;
  setMargins(facts_, 0, 4);
  column->addLayout(facts_);
  view->installEventFilter(this);
  connect(what_, &QComboBox::activated, this, [this] {
    rows_.clear();
    showRows();
    ask();
  });
  connect(copy_, &QToolButton::clicked, this, &MeasureCard::copy);
  connect(close, &QToolButton::clicked, this, &MeasureCard::end);
  // A place that completes a measure ends the question before the next one is asked.
  connect(&picking_, &Picking::changed, this, &MeasureCard::follow, Qt::QueuedConnection);
  hide();
}

Measured MeasureCard::chosen() const { return static_cast<Measured>(what_->currentIndex()); }

void MeasureCard::begin() {
  rows_.clear();
  showRows();
  show();
  raise();
  ask();
}

void MeasureCard::end() {
  hide();
  if (picking_.prompt() == promptFor(chosen())) picking_.cancel();
}

void MeasureCard::ask() {
  picking_.ask(promptFor(chosen()), placesFor(chosen()), [this](const auto& places) { take(places); });
}

void MeasureCard::follow() {
  if (!isVisibleTo(parentWidget())) return;
  if (picking_.prompt() != promptFor(chosen())) return hide();  // ended, or somebody else asks
  const int taken = static_cast<int>(picking_.soFar().size());
  if (chosen() == Measured::face)
    prompt_->setText(tr("Click a face."));
  else
    prompt_->setText(tr("Click point %1 of %2.").arg(taken + 1).arg(picking_.wanted()));
  place();
}

void MeasureCard::take(const std::vector<PickedPlace>& places) {
  // What is seen is measured: in a frame of a run blocks where they have got to.
  std::vector<PickedPlace> seen = places;
  for (PickedPlace& place : seen) {
    if (place.now) place.normal = place.now->normal;
    place.point = place.seen();
  }
  rows_ = measure(chosen(), seen, document_.project().origin);
  showRows();
  ask();
}

void MeasureCard::showRows() {
  while (facts_->rowCount() > 0) facts_->removeRow(0);
  for (const MeasuredRow& row : rows_) {
    auto* value = makeLabel(row.value);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    facts_->addRow(makeLabel(row.name, "muted"), value);
  }
  copy_->setEnabled(!rows_.empty());
  place();
}

void MeasureCard::copy() {
  QStringList lines;
  for (const MeasuredRow& row : rows_) lines << row.name + u'\t' + row.value;
  QApplication::clipboard()->setText(lines.join(u'\n'));
}

void MeasureCard::place() {
  adjustSize();
  move(away, below_prompt);
}

bool MeasureCard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  return QFrame::eventFilter(watched, event);
}

}  // namespace talus
