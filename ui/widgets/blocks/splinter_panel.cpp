#include "widgets/blocks/splinter_panel.hpp"

#include <QHeaderView>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "session/session.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/plain_table.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

constexpr std::size_t most_marks = 20;  // labels in the view that can still be read
constexpr double least_view = 2;        // m across, round a splinter

QString fateOf(const Splinter& splinter) {
  switch (splinter.fate) {
    case Splinter::Fate::dropped:
      return QObject::tr("left out");
    case Splinter::Fate::merged:
      return QObject::tr("part of %1").arg(text(splinter.merged_into));
    case Splinter::Fate::refused:
      break;
  }
  return QObject::tr("refused");
}

/// What the view shows round it: as wide as a plate of its volume and thickness, and more.
MarkedPlace placeOf(const Splinter& splinter) {
  const double across = splinter.thickness > 0 ? std::sqrt(splinter.volume / splinter.thickness) : 0;
  return {splinter.where, std::max(2 * across, least_view),
          QObject::tr("splinter, %1 thick").arg(numbers::quantity(splinter.thickness, "m")).toStdString()};
}

}  // namespace

SplinterPanel::SplinterPanel(Session& session)
    : session_(session), words_(makeWrappedLabel({})), table_(new PlainTable), buttons_(new QWidget) {
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  auto* head = makePlane("header");
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(12, 4, 12, 4);
  row->addWidget(words_, 1);
  setMargins(new QHBoxLayout(buttons_), 0, 6);
  row->addWidget(buttons_);
  column->addWidget(head);
  table_->setObjectName(QStringLiteral("splinters"));
  table_->setAccessibleName(tr("Splinters"));
  column->addWidget(table_, 1);
  addButton(tr("Show"), tr("Lets the view go to the chosen one"), [this] { showChosen(); });
  addButton(tr("Move the joint"), tr("Selects the cut beside the chosen one, to be moved"), [this] { moveJoint(); });
  drop_ = addButton(tr("Drop them"), tr("Splinters are left out from now on; their volume is told"),
                    [this] { session_.splinters.decide(SplinterRule::drop); });
  merge_ = addButton(tr("Merge with neighbours"),
                     tr("Each becomes part of the block that it shares most of its surface with"),
                     [this] { session_.splinters.decide(SplinterRule::merge); });
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int current) {
    if (current >= 0) showChosen();
  });
  connect(&session_.splinters, &SplinterList::changed, this, &SplinterPanel::refresh);
  refresh();
}

QPushButton* SplinterPanel::addButton(const QString& words, const QString& tip, std::function<void()> act) {
  auto* button = makeButton(words);
  button->setToolTip(tip);
  connect(button, &QPushButton::clicked, this, [this, act] {
    try {
      act();
    } catch (const InputError& error) {
      session_.messages.add(problemOf(error));
    }
  });
  buttons_->layout()->addWidget(button);
  return button;
}

void SplinterPanel::refresh() {
  const auto& splinters = session_.splinters.all();
  const bool refused = session_.splinters.areRefused();
  double volume = 0;
  std::vector<QStringList> rows;
  const auto& solids = session_.project.document().project().solids;
  for (const Splinter& one : splinters) {
    volume += one.volume;
    const auto solid = static_cast<std::size_t>(one.solid);
    QStringList cells{solid < solids.size() ? text(solids[solid].name) : QString(), fateOf(one),
                      numbers::significant(one.thickness), numbers::significant(one.volume)};
    for (int axis = 0; axis < 3; ++axis) cells << numbers::fixed(one.where[axis], 2);
    rows.push_back(cells);
  }
  words_->setText(
      refused
          ? tr("The rock was not cut: %1 too thin to be blocks.").arg(numbers::counted(splinters.size(), "piece"))
          : tr("%1, %2 m³ together").arg(numbers::counted(splinters.size(), "splinter"), numbers::significant(volume)));
  const QSignalBlocker silent(table_);
  table_->setContent(
      {tr("In"), tr("What became of it"), tr("Thickness m"), tr("Volume m³"), tr("E m"), tr("N m"), tr("Z m")}, rows,
      {true, true, false, false, false, false, false});
  table_->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  table_->setCurrentCell(-1, -1);
  drop_->setEnabled(session_.project.document().project().splinters.rule != SplinterRule::drop);
  merge_->setEnabled(session_.project.document().project().splinters.rule != SplinterRule::merge);
  if (isVisible()) mark();
}

void SplinterPanel::mark() {
  const auto& splinters = session_.splinters.all();
  std::vector<MarkedPlace> places;
  for (std::size_t i = 0; i < std::min(splinters.size(), most_marks); ++i) places.push_back(placeOf(splinters[i]));
  session_.display.mark(std::move(places));
}

void SplinterPanel::showEvent(QShowEvent* event) {
  mark();
  QWidget::showEvent(event);
}

void SplinterPanel::hideEvent(QHideEvent* event) {
  session_.display.mark({});
  QWidget::hideEvent(event);
}

std::size_t SplinterPanel::chosen() const { return static_cast<std::size_t>(std::max(0, table_->currentRow())); }

void SplinterPanel::showChosen() {
  const auto& splinters = session_.splinters.all();
  if (chosen() < splinters.size()) session_.display.showPlace(placeOf(splinters[chosen()]));
}

void SplinterPanel::moveJoint() {
  const auto& splinters = session_.splinters.all();
  if (chosen() >= splinters.size()) return;
  const auto cut = session_.splinters.cutBeside(splinters[chosen()]);
  if (!cut) return;
  session_.display.goTo(WorkflowPage::joints);
  session_.project.selection().select({Item::Kind::cut, *cut});
}

}  // namespace talus
