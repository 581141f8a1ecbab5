#include "widgets/project/problem_list.hpp"

#include <QKeyEvent>
#include <QPainter>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

#include "session/display.hpp"
#include "session/project_problems.hpp"

namespace talus {

namespace {

QString iconOf(Problem::Severity severity) {
  switch (severity) {
    case Problem::Severity::info:
      return QStringLiteral("info");
    case Problem::Severity::warning:
      return QStringLiteral("warning");
    case Problem::Severity::error:
      break;
  }
  return QStringLiteral("error");
}

theme::Tone toneOf(Problem::Severity severity) {
  switch (severity) {
    case Problem::Severity::info:
      return theme::Tone::muted;
    case Problem::Severity::warning:
      return theme::Tone::warn;
    case Problem::Severity::error:
      break;
  }
  return theme::Tone::error;
}

QPushButton* makeShowButton() {
  auto* button = makeButton(QObject::tr("Show in view"));
  button->setToolTip(QObject::tr("Turns the view to the place and selects its blocks"));
  return button;
}

QString sentence(const Problem& problem) {
  return problem.place.isEmpty() ? problem.problem : QStringLiteral("%1: %2").arg(problem.place, problem.problem);
}

}  // namespace

QIcon iconOfProblems(Problem::Severity worst) { return theme::icon(iconOf(worst), toneOf(worst)); }

ProblemRow::ProblemRow(const Problem& problem, Display& display)
    : problem_(problem), display_(display), leads_(problem.where || !problem.field.isEmpty()) {
  setFocusPolicy(leads_ ? Qt::StrongFocus : Qt::NoFocus);
  setAccessibleName(sentence(problem));
  setAccessibleDescription(problem.remedy);
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(12, 4, 12, 4);
  line->setSpacing(8);
  line->addWidget(new Glyph(iconOf(problem.severity), toneOf(problem.severity)), 0, Qt::AlignTop);
  auto* words = new QVBoxLayout;
  setMargins(words, 0, 1);
  auto* what = makeWrappedLabel(sentence(problem));
  what->setTextInteractionFlags(Qt::TextSelectableByMouse);
  words->addWidget(what);
  words->addWidget(makeWrappedLabel(problem.remedy, "small"));
  line->addLayout(words, 1);
  if (!leads_) return;
  auto* button = problem.where ? makeShowButton() : makeButton(tr("Go there"));
  if (!problem.where) button->setToolTip(tr("Selects it and puts the keyboard into its field (Enter)"));
  button->setFocusPolicy(Qt::NoFocus);  // the row itself has it
  connect(button, &QPushButton::clicked, this, &ProblemRow::go);
  line->addWidget(button, 0, Qt::AlignTop);
}

void ProblemRow::go() {
  if (problem_.where)
    display_.showTrouble(*problem_.where);
  else if (leads_)
    display_.showField(problem_.field);
}

void ProblemRow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
    go();
  else
    QFrame::keyPressEvent(event);
}

void ProblemRow::mouseDoubleClickEvent(QMouseEvent*) { go(); }

void ProblemRow::paintEvent(QPaintEvent* event) {
  QFrame::paintEvent(event);
  if (!hasFocus()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme::colours().accent, 1));
  painter.drawRoundedRect(QRectF(rect()).adjusted(3.5, 0.5, -3.5, -0.5), 4, 4);
}

ProblemList::ProblemList(const ProjectProblems& problems, Messages& messages, Display& display)
    : problems_(problems), messages_(messages), display_(display) {
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  auto* content = makePlane("surface");
  rows_ = new QVBoxLayout(content);
  rows_->setContentsMargins(0, 4, 0, 4);
  rows_->setSpacing(0);
  column->addWidget(makeScrolled(content));
  // A row that asked for a change still handles its event: it must not be deleted under itself.
  connect(&messages_, &Messages::problemsChanged, this, &ProblemList::refresh, Qt::QueuedConnection);
  connect(&problems_, &ProjectProblems::changed, this, &ProblemList::refresh, Qt::QueuedConnection);
  refresh();
}

void ProblemList::refresh() {
  clearLayout(*rows_);
  std::vector<Problem> problems = messages_.problems();
  problems.insert(problems.end(), problems_.all().begin(), problems_.all().end());
  if (problems.empty()) {
    auto* none = makeLabel(tr("No problems."), "muted");
    none->setContentsMargins(12, 6, 12, 6);
    rows_->addWidget(none);
  }
  for (const Problem& problem : problems) rows_->addWidget(new ProblemRow(problem, display_));
  rows_->addStretch();
}

ProblemStrip::ProblemStrip(Messages& messages, Display& display)
    : glyph_(new Glyph(QStringLiteral("error"), theme::Tone::error)),
      what_(makeWrappedLabel({}, "strong")),
      remedy_(makeWrappedLabel({})),
      show_(makeShowButton()) {
  setObjectName(QStringLiteral("problem-strip"));
  setProperty("plane", "problem");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 6, 6, 6);
  row->setSpacing(8);
  row->addWidget(glyph_, 0, Qt::AlignVCenter);
  auto* words = new QVBoxLayout;
  setMargins(words, 0, 1);
  for (auto* label : {what_, remedy_}) {
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words->addWidget(label);
  }
  row->addLayout(words, 1);
  row->addWidget(show_, 0, Qt::AlignVCenter);
  connect(show_, &QPushButton::clicked, this, [this, &display] { display.showTrouble(*where_); });
  auto* close = makeTool(QStringLiteral("close"), tr("Close this message"));
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  row->addWidget(close, 0, Qt::AlignTop);
  connect(&messages, &Messages::problemAdded, this, &ProblemStrip::show);
  connect(&messages, &Messages::problemsChanged, this, [this, &messages] {
    const auto& problems = messages.problems();
    const bool stays =
        std::any_of(problems.begin(), problems.end(), [this](const auto& one) { return one.number == number_; });
    if (!stays) hide();  // it was of another file, or is settled
  });
  hide();
}

void ProblemStrip::show(const Problem& problem) {
  setProperty("plane", problem.severity == Problem::Severity::error ? "problem" : "notice");
  style()->unpolish(this);
  style()->polish(this);
  glyph_->setIcon(iconOf(problem.severity), toneOf(problem.severity));
  what_->setText(sentence(problem));
  remedy_->setText(problem.remedy);
  where_ = problem.where;
  number_ = problem.number;
  show_->setVisible(where_.has_value());
  setVisible(true);
}

}  // namespace talus
