#include "widgets/struggle_panel.hpp"

#include "widgets/numbers.hpp"

namespace talus {

namespace {

QString text(const std::string& s) { return QString::fromStdString(s); }

QString contactOf(const Struggle& struggle) {
  if (struggle.blocks[0].empty()) return QObject::tr("no place can be told");
  const QString contact = text(contact_text(struggle));
  return struggle.joint.empty() ? contact : QObject::tr("%1, joint %2").arg(contact, text(struggle.joint));
}

QString costOf(const Struggle& struggle) {
  QStringList words;
  if (struggle.cuts > 0) words << numbers::counted(struggle.cuts, "cut");
  words << numbers::counted(struggle.iterations, "iteration")
        << QObject::tr("hardest at t = %1 s").arg(numbers::significant(struggle.time));
  return text(position_text(struggle)) + QStringLiteral(": ") + words.join(QStringLiteral(", "));
}

QLabel* makeSmallWords() {
  auto* label = makeLabel({}, "small");
  label->setWordWrap(true);
  return label;
}

}  // namespace

StruggleRow::StruggleRow()
    : contact_(new ElidedLabel({}, "strong")), cost_(makeSmallWords()), advice_(makeSmallWords()) {
  auto* row = new QHBoxLayout(this);
  setMargins(row, 0, 6);
  row->addWidget(new Glyph(QStringLiteral("warning"), theme::Tone::warn), 0, Qt::AlignTop);
  auto* words = new QVBoxLayout;
  setMargins(words, 0, 1);
  auto* top = new QHBoxLayout;
  setMargins(top, 0, 4);
  top->addWidget(contact_, 1);
  auto* show = makeButton(tr("Show"), "link");
  show->setToolTip(tr("Turns the view to the place and selects its blocks"));
  connect(show, &QPushButton::clicked, this, [this] { emit wanted(struggle_); });
  top->addWidget(show);
  words->addLayout(top);
  words->addWidget(cost_);
  words->addWidget(advice_);
  row->addLayout(words, 1);
}

void StruggleRow::show(const Struggle& struggle) {
  struggle_ = struggle;
  contact_->setText(contactOf(struggle));
  cost_->setText(costOf(struggle));
  QString advice = text(struggle.advice);
  if (!advice.isEmpty()) advice[0] = advice[0].toUpper();
  advice_->setText(advice);
  setVisible(true);
}

StrugglePanel::StrugglePanel(Workspace& workspace)
    : workspace_(workspace), heading_(makeLabel({}, "section")), column_(new QVBoxLayout) {
  auto* whole = new QVBoxLayout(this);
  setMargins(whole, 0, 0);
  whole->addWidget(makeLine(Qt::Horizontal));
  column_->setContentsMargins(12, 10, 12, 10);
  column_->setSpacing(8);
  column_->addWidget(heading_);
  whole->addLayout(column_);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // what it says does not make the panel wider
  connect(&workspace_, &Workspace::strugglesChanged, this, &StrugglePanel::refresh);
  connect(&workspace_.job(), &SolverJob::stateChanged, this, &StrugglePanel::refresh);
  refresh();
}

void StrugglePanel::refresh() {
  const auto& struggles = workspace_.struggles();
  setVisible(!struggles.empty());
  heading_->setText(workspace_.job().isBusy() ? tr("Struggling at") : tr("Where it was hard"));
  while (rows_.size() < struggles.size()) {
    auto* row = new StruggleRow;
    connect(row, &StruggleRow::wanted, &workspace_, &Workspace::showStruggle);
    column_->addWidget(row);
    rows_.push_back(row);
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (i < struggles.size())
      rows_[i]->show(struggles[i]);
    else
      rows_[i]->hide();
  }
}

}  // namespace talus
