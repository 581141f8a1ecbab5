#include "widgets/window/rail.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>

#include "jobs/solver_job.hpp"
#include "session/session.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

QString stateWord(RailItem::State state) {
  switch (state) {
    case RailItem::State::done:
      return QObject::tr("done");
    case RailItem::State::doubtful:
      return QObject::tr("doubtful");
    case RailItem::State::busy:
      return QObject::tr("running");
    case RailItem::State::locked:
      return QObject::tr("not yet possible");
    case RailItem::State::open:
      break;
  }
  return QObject::tr("to do");
}

}  // namespace

Rail::Rail(Session& session) : session_(session) {
  setProperty("plane", "rail");
  setFixedWidth(theme::now().metrics.rail);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 6, 0, 6);
  column->setSpacing(0);
  for (const WorkflowPage page : all_pages) {
    if (page == WorkflowPage::solve) {
      auto* gap = new QHBoxLayout;
      gap->setContentsMargins(18, 6, 18, 6);
      gap->addWidget(makeLine(Qt::Horizontal));
      column->addLayout(gap);
    }
    auto* item = new RailItem(page);
    connect(item, &RailItem::chosen, this, [this, page] { session_.display.goTo(page); });
    column->addWidget(item, 10);
    items_[page] = item;
  }
  column->addStretch(1);
  connect(&session_.display, &Display::pageChanged, this, &Rail::refresh);
  connect(&session_.project, &CurrentProject::opened, this, &Rail::refresh);
  connect(&session_.project, &CurrentProject::systemChanged, this, &Rail::refresh);
  connect(&session_.project.document(), &Document::projectChanged, this, &Rail::refresh);
  connect(&session_.playback, &Playback::framesChanged, this, &Rail::refresh);
  connect(&session_.run, &CurrentRun::reportChanged, this, &Rail::refresh);
  connect(&session_.project.problems(), &ProjectProblems::changed, this, &Rail::refresh);
  connect(&session_.run.job(), &SolverJob::stateChanged, this, &Rail::refresh);
  connect(&session_.run, &CurrentRun::outsideChanged, this, &Rail::refresh);
  refresh();
}

QString Rail::errorOn(WorkflowPage page) const {
  for (const Problem& one : session_.project.problems().all())
    if (one.severity == Problem::Severity::error && !one.field.isEmpty() && pageOf(one.field) == page)
      return sentenceCase(one.problem);
  return {};
}

void Rail::refresh() {
  using State = RailItem::State;
  const Project& project = session_.project.document().project();
  const JobState job = session_.run.job().state();
  const bool meshed = session_.project.systemIsCurrent();
  const QString staleBlocks = meshed || !session_.project.system() ? QString() : tr("Changed since it was cut");
  const bool meshing = job == JobState::meshing;
  const bool running = (session_.run.isBusy() && !meshing) || session_.run.outside().isOn();
  auto doneIf = [](bool done) { return done ? State::done : State::open; };
  auto set = [this](WorkflowPage page, State state, const QString& why = {}) { items_.at(page)->setState(state, why); };
  auto setMade = [&](WorkflowPage page, bool made) {
    const QString wrong = errorOn(page);
    set(page, made && !wrong.isEmpty() ? State::doubtful : doneIf(made), made ? wrong : QString());
  };
  setMade(WorkflowPage::geometry, !project.solids.empty());
  setMade(WorkflowPage::joints, !project.joints.empty());
  for (const WorkflowPage page : {WorkflowPage::blocks, WorkflowPage::mesh})
    set(page, meshing ? State::busy : doneIf(meshed), staleBlocks);
  setMade(WorkflowPage::materials, !project.materials.empty());
  const bool acts = !project.loads.empty() || !project.constraints.empty() || project.gravity.norm() > 0;
  setMade(WorkflowPage::loads, acts && !project.solids.empty());  // gravity alone acts on nothing
  setMade(WorkflowPage::stages, !project.stages.empty());
  const bool solved = !session_.playback.times().empty() && !session_.run.job().isBusy();
  const bool current = solved && session_.playback.isCurrent();
  const QString shortfall = solved ? session_.run.shortfall() : QString();
  const State outcome = shortfall.isEmpty() ? State::done : State::doubtful;
  const QString why = session_.run.whyNotSolve();
  if (running)
    set(WorkflowPage::solve, State::busy);
  else if (current)
    set(WorkflowPage::solve, outcome, sentenceCase(shortfall));
  else
    set(WorkflowPage::solve, why.isEmpty() ? State::open : State::locked, why);
  if (session_.playback.times().empty())
    set(WorkflowPage::results, State::locked, tr("Nothing has been solved yet"));
  else
    set(WorkflowPage::results, current ? outcome : State::open,
        current  ? sentenceCase(shortfall)
        : solved ? tr("Changed since it was solved")
                 : QString());
  for (const auto& [page, item] : items_) item->setCurrent(page == session_.display.page());
}

RailItem::RailItem(WorkflowPage page) : page_(page) {
  setAttribute(Qt::WA_Hover);
  setFocusPolicy(Qt::TabFocus);
  setMinimumHeight(46);
  setMaximumHeight(58);
  setFixedWidth(theme::now().metrics.rail - 1);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  setAccessibleName(pageTitle(page));
  setObjectName(QStringLiteral("rail-%1").arg(QLatin1String(pageKey(page))));
}

void RailItem::setState(State state, const QString& why) {
  state_ = state;
  const QString key = tr("%1 (Ctrl+%2)").arg(pageTitle(page_)).arg(static_cast<int>(page_) + 1);
  setToolTip(why.isEmpty() ? key : key + u'\n' + why);
  setAccessibleDescription(why.isEmpty() ? stateWord(state) : stateWord(state) + QStringLiteral(": ") + why);
  update();
}

void RailItem::setCurrent(bool current) {
  current_ = current;
  update();
}

void RailItem::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit chosen();
}

void RailItem::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Return)
    emit chosen();
  else
    QWidget::keyPressEvent(event);
}

void RailItem::paintEvent(QPaintEvent*) {
  const Colours& c = theme::colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(hasFocus() ? QPen(c.accent, 1) : QPen(Qt::NoPen));
  if (current_ || underMouse() || hasFocus()) {
    painter.setBrush(current_ ? c.accentSoft : underMouse() ? c.hover : c.window);
    painter.drawRoundedRect(QRectF(rect()).adjusted(5, 2, -6, -2), 6, 6);
  }
  if (current_) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(c.accent);
    painter.drawRoundedRect(QRectF(0, 10, 3, height() - 20), 1.5, 1.5);
  }
  const int size = theme::now().metrics.iconRail, x = (width() - size) / 2, y = (height() - size - 16) / 2;
  const bool locked = state_ == State::locked;
  theme::icon(QLatin1String(pageKey(page_)), current_ ? theme::Tone::accent : theme::Tone::muted)
      .paint(&painter, QRect(x, y, size, size), Qt::AlignCenter, locked ? QIcon::Disabled : QIcon::Normal);
  painter.setFont(theme::font(theme::now().type.small, current_ ? QFont::DemiBold : QFont::Medium));
  painter.setPen(current_ ? c.accentText : locked ? c.textFaint : c.textMuted);
  painter.drawText(QRect(0, y + size, width() - 1, 18), Qt::AlignCenter, pageTitle(page_));

  // The badge says by its shape what its colour says too.
  const QRect badge(x + 17, y - 3, 13, 13);
  painter.setPen(QPen(c.window, 1.5));
  if (state_ == State::done) {
    painter.setBrush(c.ok);
    painter.drawEllipse(badge);
    theme::icon(QStringLiteral("check"), theme::Tone::onAccent).paint(&painter, badge.adjusted(2, 2, -2, -2));
  } else if (state_ == State::doubtful) {
    painter.setBrush(c.warn);
    painter.drawEllipse(badge);
    painter.setPen(c.onAccent);
    painter.setFont(theme::font(10, QFont::Bold));
    painter.drawText(badge, Qt::AlignCenter, QStringLiteral("!"));
  } else if (state_ == State::busy) {
    painter.setBrush(c.surface);
    painter.drawEllipse(badge);
    painter.setPen(QPen(c.border, 2.2));
    painter.drawEllipse(badge.adjusted(2, 2, -2, -2));
    painter.setPen(QPen(c.accent, 2.2));
    painter.drawArc(badge.adjusted(2, 2, -2, -2), 90 * 16, -223 * 16);
  }
}

}  // namespace talus
