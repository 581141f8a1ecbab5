#include "widgets/rail.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>

#include "widgets/parts.hpp"

namespace talus {

Rail::Rail(Workspace& workspace) : workspace_(workspace) {
  setProperty("plane", "rail");
  setFixedWidth(theme::now().metrics.rail);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 6, 0, 6);
  column->setSpacing(0);
  for (const Step step : all_steps) {
    if (step == Step::solve) {
      auto* gap = new QHBoxLayout;
      gap->setContentsMargins(18, 6, 18, 6);
      gap->addWidget(makeLine(Qt::Horizontal));
      column->addLayout(gap);
    }
    auto* item = new RailStep(step);
    connect(item, &RailStep::chosen, this, [this, step] { workspace_.goTo(step); });
    column->addWidget(item, 10);
    steps_[step] = item;
  }
  column->addStretch(1);
  for (const auto signal : {&Workspace::stepChanged, &Workspace::projectOpened, &Workspace::systemChanged,
                            &Workspace::framesChanged, &Workspace::reportChanged, &Workspace::problemsChanged})
    connect(&workspace_, signal, this, &Rail::refresh);
  connect(&workspace_.job(), &SolverJob::stateChanged, this, &Rail::refresh);
  refresh();
}

void Rail::refresh() {
  using State = RailStep::State;
  const Project& project = workspace_.document().project();
  const JobState job = workspace_.job().state();
  const bool meshed = workspace_.system() != nullptr;
  const bool meshing = job == JobState::meshing, running = workspace_.job().isBusy() && !meshing;
  auto doneIf = [](bool done) { return done ? State::done : State::open; };
  auto set = [this](Step step, State state, const QString& why = {}) { steps_.at(step)->setState(state, why); };
  set(Step::geometry, doneIf(!project.solids.empty()));
  set(Step::joints, doneIf(!project.joints.empty()));
  set(Step::blocks, meshing ? State::busy : doneIf(meshed));
  set(Step::mesh, meshing ? State::busy : doneIf(meshed));
  set(Step::materials, doneIf(!project.materials.empty()));
  set(Step::loads, doneIf(!project.loads.empty() || !project.constraints.empty() || project.gravity.norm() > 0));
  set(Step::stages, doneIf(!project.stages.empty()));
  const bool solved = !workspace_.frameTimes().empty() && !workspace_.job().isBusy();
  const QString why = workspace_.whyNotSolve();
  if (running)
    set(Step::solve, State::busy);
  else if (solved && workspace_.resultsAreCurrent())
    set(Step::solve, State::done);
  else
    set(Step::solve, why.isEmpty() ? State::open : State::locked, why);
  if (workspace_.frameTimes().empty())
    set(Step::results, State::locked, tr("Nothing has been solved yet"));
  else
    set(Step::results, doneIf(solved && workspace_.resultsAreCurrent()));
  for (const auto& [step, item] : steps_) item->setCurrent(step == workspace_.step());
}

RailStep::RailStep(Step step) : step_(step) {
  setAttribute(Qt::WA_Hover);
  setFocusPolicy(Qt::TabFocus);
  setMinimumHeight(46);
  setMaximumHeight(58);
  setFixedWidth(theme::now().metrics.rail - 1);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  setAccessibleName(stepTitle(step));
  setObjectName(QStringLiteral("rail-%1").arg(QLatin1String(stepKey(step))));
}

void RailStep::setState(State state, const QString& why) {
  state_ = state;
  const QString key = tr("%1 (Ctrl+%2)").arg(stepTitle(step_)).arg(static_cast<int>(step_) + 1);
  setToolTip(why.isEmpty() ? key : key + u'\n' + why);
  update();
}

void RailStep::setCurrent(bool current) {
  current_ = current;
  update();
}

void RailStep::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit chosen();
}

void RailStep::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Return)
    emit chosen();
  else
    QWidget::keyPressEvent(event);
}

void RailStep::paintEvent(QPaintEvent*) {
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
  theme::icon(QLatin1String(stepKey(step_)), current_ ? theme::Tone::accent : theme::Tone::muted)
      .paint(&painter, QRect(x, y, size, size), Qt::AlignCenter, locked ? QIcon::Disabled : QIcon::Normal);
  painter.setFont(theme::font(theme::now().type.small, current_ ? QFont::DemiBold : QFont::Medium));
  painter.setPen(current_ ? c.accentText : locked ? c.textFaint : c.textMuted);
  painter.drawText(QRect(0, y + size, width() - 1, 18), Qt::AlignCenter, stepTitle(step_));

  // The badge says by its shape what its colour says too.
  const QRect badge(x + 17, y - 3, 13, 13);
  painter.setPen(QPen(c.window, 1.5));
  if (state_ == State::done) {
    painter.setBrush(c.ok);
    painter.drawEllipse(badge);
    theme::icon(QStringLiteral("check"), theme::Tone::onAccent).paint(&painter, badge.adjusted(2, 2, -2, -2));
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
