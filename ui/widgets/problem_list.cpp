#include "widgets/problem_list.hpp"

#include <QStyle>

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

ProblemList::ProblemList(Workspace& workspace) : workspace_(workspace) {
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  auto* content = makePlane("surface");
  rows_ = new QVBoxLayout(content);
  rows_->setContentsMargins(0, 4, 0, 4);
  rows_->setSpacing(0);
  column->addWidget(makeScrolled(content));
  connect(&workspace_, &Workspace::problemsChanged, this, &ProblemList::refresh);
  refresh();
}

void ProblemList::refresh() {
  while (auto* item = rows_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  if (workspace_.problems().empty()) {
    auto* none = makeLabel(tr("No problems."), "muted");
    none->setContentsMargins(12, 6, 12, 6);
    rows_->addWidget(none);
  }
  for (const Problem& problem : workspace_.problems()) {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(12, 4, 12, 4);
    line->setSpacing(8);
    line->addWidget(new Glyph(iconOf(problem.severity), toneOf(problem.severity)), 0, Qt::AlignTop);
    auto* words = new QVBoxLayout;
    setMargins(words, 0, 1);
    auto* what = makeLabel(sentence(problem));
    what->setWordWrap(true);
    what->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words->addWidget(what);
    auto* remedy = makeLabel(problem.remedy, "small");
    remedy->setWordWrap(true);
    words->addWidget(remedy);
    line->addLayout(words, 1);
    if (problem.where) {
      auto* show = makeShowButton();
      connect(show, &QPushButton::clicked, this, [this, where = *problem.where] { workspace_.showStruggle(where); });
      line->addWidget(show, 0, Qt::AlignTop);
    }
    rows_->addWidget(row);
  }
  rows_->addStretch();
}

ProblemStrip::ProblemStrip(Workspace& workspace)
    : glyph_(new Glyph(QStringLiteral("error"), theme::Tone::error)),
      what_(makeLabel({}, "strong")),
      remedy_(makeLabel({})),
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
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    words->addWidget(label);
  }
  row->addLayout(words, 1);
  row->addWidget(show_, 0, Qt::AlignVCenter);
  connect(show_, &QPushButton::clicked, this, [this, &workspace] { workspace.showStruggle(*where_); });
  auto* close = makeTool(QStringLiteral("close"), tr("Close this message"));
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  row->addWidget(close, 0, Qt::AlignTop);
  connect(&workspace, &Workspace::problemAdded, this, &ProblemStrip::show);
  connect(&workspace, &Workspace::projectOpened, this, &QWidget::hide);
  connect(&workspace, &Workspace::strugglesChanged, this, [this, &workspace] {
    if (where_ && workspace.struggles().empty()) hide();  // it was of a run before
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
  show_->setVisible(where_.has_value());
  setVisible(true);
}

}  // namespace talus
