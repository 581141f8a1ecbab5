#include "widgets/project/problem_list.hpp"

#include "session/display.hpp"

#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

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

ProblemList::ProblemList(Messages& messages, Display& display) : messages_(messages), display_(display) {
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  auto* content = makePlane("surface");
  rows_ = new QVBoxLayout(content);
  rows_->setContentsMargins(0, 4, 0, 4);
  rows_->setSpacing(0);
  column->addWidget(makeScrolled(content));
  connect(&messages_, &Messages::problemsChanged, this, &ProblemList::refresh);
  refresh();
}

void ProblemList::refresh() {
  clearLayout(*rows_);
  if (messages_.problems().empty()) {
    auto* none = makeLabel(tr("No problems."), "muted");
    none->setContentsMargins(12, 6, 12, 6);
    rows_->addWidget(none);
  }
  for (const Problem& problem : messages_.problems()) {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(12, 4, 12, 4);
    line->setSpacing(8);
    line->addWidget(new Glyph(iconOf(problem.severity), toneOf(problem.severity)), 0, Qt::AlignTop);
    auto* words = new QVBoxLayout;
    setMargins(words, 0, 1);
    auto* what = makeWrappedLabel(sentence(problem));
    what->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words->addWidget(what);
    auto* remedy = makeWrappedLabel(problem.remedy, "small");
    words->addWidget(remedy);
    line->addLayout(words, 1);
    if (problem.where) {
      auto* show = makeShowButton();
      connect(show, &QPushButton::clicked, this, [this, where = *problem.where] { display_.showTrouble(where); });
      line->addWidget(show, 0, Qt::AlignTop);
    }
    rows_->addWidget(row);
  }
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
    const bool stays = std::any_of(problems.begin(), problems.end(), [this](const auto& one) { return one.number == number_; });
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
