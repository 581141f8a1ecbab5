#include "widgets/run/trouble_panel.hpp"

#include "document/schema.hpp"
#include "jobs/solver_job.hpp"
#include "session/current_run.hpp"
#include "session/display.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

QString contactOf(const ConvergenceTrouble& trouble) {
  if (trouble.blocks[0].empty()) return QObject::tr("no place can be told");
  const QString contact = text(contact_text(trouble));
  return trouble.joint.empty() ? contact : QObject::tr("%1, joint %2").arg(contact, text(trouble.joint));
}

QString costOf(const ConvergenceTrouble& trouble) {
  QStringList words;
  if (trouble.cuts > 0) words << numbers::counted(trouble.cuts, "cut");
  words << numbers::counted(trouble.iterations, "iteration")
        << QObject::tr("hardest at t = %1 s").arg(numbers::significant(trouble.time));
  return text(position_text(trouble)) + QStringLiteral(": ") + words.join(QStringLiteral(", "));
}

}  // namespace

TroubleRow::TroubleRow()
    : contact_(new ElidedLabel({}, "strong")),
      cost_(makeWrappedLabel({}, "small")),
      advice_(makeWrappedLabel({}, "small")) {
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
  connect(show, &QPushButton::clicked, this, [this] { emit wanted(trouble_); });
  top->addWidget(show);
  words->addLayout(top);
  words->addWidget(cost_);
  words->addWidget(advice_);
  row->addLayout(words, 1);
}

void TroubleRow::show(const ConvergenceTrouble& trouble) {
  trouble_ = trouble;
  contact_->setText(contactOf(trouble));
  cost_->setText(costOf(trouble));
  QString advice = schema::inWordsOfForms(text(trouble.advice));
  if (!advice.isEmpty()) advice[0] = advice[0].toUpper();
  advice_->setText(advice);
  setVisible(true);
}

TroublePanel::TroublePanel(CurrentRun& run, Display& display)
    : run_(run), display_(display), heading_(makeLabel({}, "section")), column_(new QVBoxLayout) {
  auto* whole = new QVBoxLayout(this);
  setMargins(whole, 0, 0);
  whole->addWidget(makeLine(Qt::Horizontal));
  column_->setContentsMargins(12, 10, 12, 10);
  column_->setSpacing(8);
  column_->addWidget(heading_);
  whole->addLayout(column_);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // what it says does not make the panel wider
  connect(&run_, &CurrentRun::troublesChanged, this, &TroublePanel::refresh);
  connect(&run_.job(), &SolverJob::stateChanged, this, &TroublePanel::refresh);
  refresh();
}

void TroublePanel::refresh() {
  const auto& troubles = run_.troubles();
  setVisible(!troubles.empty());
  heading_->setText(run_.job().isBusy() ? tr("Convergence trouble so far") : tr("Convergence trouble"));
  while (rows_.size() < troubles.size()) {
    auto* row = new TroubleRow;
    connect(row, &TroubleRow::wanted, &display_, &Display::showTrouble);
    column_->addWidget(row);
    rows_.push_back(row);
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (i < troubles.size())
      rows_[i]->show(troubles[i]);
    else
      rows_[i]->hide();
  }
}

}  // namespace talus
