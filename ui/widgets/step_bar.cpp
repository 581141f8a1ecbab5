#include "widgets/step_bar.hpp"

#include "widgets/field_chooser.hpp"
#include "widgets/numbers.hpp"
#include "widgets/parts.hpp"
#include "widgets/top_bar.hpp"

namespace talus {

namespace {

QString count(size_t n) { return numbers::whole(static_cast<long long>(n)); }
QString counted(size_t n, const char* noun) { return numbers::counted(static_cast<long long>(n), noun); }

QHBoxLayout* makeRow(QWidget* page) {
  auto* row = new QHBoxLayout(page);
  setMargins(row, 0, 2);
  return row;
}

}  // namespace

StepBar::StepBar(Workspace& workspace, WindowActions& actions) : workspace_(workspace), actions_(actions) {
  setProperty("plane", "top");
  setFixedHeight(theme::now().metrics.bar);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 0, 12, 0);
  row->setSpacing(8);
  title_ = makeLabel({}, "title");
  title_->setMinimumWidth(62);
  row->addWidget(title_);
  row->addWidget(makeLine(Qt::Vertical));
  pages_ = new QStackedWidget;
  pages_->addWidget(makeSetUpPage());
  pages_->addWidget(makeSolvePage());
  pages_->addWidget(makeResultsPage());
  row->addWidget(pages_);
  outcome_ = new ElidedLabel({}, "small");
  outcome_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(outcome_, 1);
  bar_ = new QProgressBar;
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  bar_->setFixedWidth(120);
  row->addWidget(bar_);
  primary_ = makeButton({}, "primary");
  primary_->setObjectName(QStringLiteral("primary"));
  connect(primary_, &QPushButton::clicked, this, [this] { primaryAction()->trigger(); });
  row->addWidget(primary_);

  for (const auto signal : {&Workspace::stepChanged, &Workspace::projectOpened, &Workspace::systemChanged,
                            &Workspace::framesChanged, &Workspace::reportChanged})
    connect(&workspace_, signal, this, &StepBar::refresh);
  connect(&workspace_, &Workspace::progressed, this, &StepBar::refreshOutcome);
  connect(&workspace_.job(), &SolverJob::stateChanged, this, &StepBar::refresh);
  for (auto* action : {actions_.mesh, actions_.solve, actions_.pause, actions_.saveFilm})
    connect(action, &QAction::changed, this, &StepBar::refreshPrimary);
  refresh();
}

QWidget* StepBar::makeSetUpPage() {
  auto* page = new QWidget;
  auto* row = makeRow(page);
  row->addWidget(makeActionButton(actions_.mesh, true));
  row->addWidget(makeActionButton(actions_.fit, true));
  row->addWidget(makeActionButton(actions_.savePicture, true));
  row->addStretch();
  return page;
}

QWidget* StepBar::makeSolvePage() {
  auto* page = new QWidget;
  auto* row = makeRow(page);
  row->addWidget(makeActionButton(actions_.oneStep, true));
  row->addWidget(makeActionButton(actions_.stop, true));
  auto* field = new FieldChooser(workspace_, this);
  row->addSpacing(6);
  row->addWidget(field->quantityBox());
  row->addWidget(field->componentBox());
  field->quantityBox()->setFixedWidth(116);
  field->componentBox()->setFixedWidth(116);
  row->addStretch();
  return page;
}

QWidget* StepBar::makeResultsPage() {
  auto* page = new QWidget;
  auto* row = makeRow(page);
  auto* field = new FieldChooser(workspace_, this);
  field->quantityBox()->setFixedWidth(136);
  field->quantityBox()->setObjectName(QStringLiteral("field"));
  field->componentBox()->setFixedWidth(136);
  row->addWidget(field->quantityBox());
  row->addSpacing(4);
  row->addWidget(field->componentBox());
  row->addSpacing(8);
  row->addWidget(makeActionButton(actions_.savePicture, true));
  row->addWidget(makeActionButton(actions_.solve, true));
  row->addStretch();
  return page;
}

void StepBar::refresh() {
  title_->setText(stepTitle(workspace_.step()));
  pages_->setCurrentIndex(isSetUp(workspace_.step()) ? 0 : workspace_.step() == Step::solve ? 1 : 2);
  refreshOutcome();
  refreshPrimary();
}

QString StepBar::runOutcome() const {
  const SolverJob& job = workspace_.job();
  if (!job.isBusy()) {
    const auto& report = workspace_.report();
    if (!report) return workspace_.whyNotSolve();
    const QString length =
        tr("%1 in %2").arg(numbers::counted(report->steps, "step"), numbers::duration(report->wall_seconds));
    return workspace_.resultsAreCurrent() ? length : tr("edited since; %1").arg(length);
  }
  if (job.state() == JobState::meshing) return tr("Cutting and meshing");
  if (job.state() == JobState::stopping) return tr("Stopping after this step");
  QString text;
  if (!workspace_.steps().empty()) {
    const auto stage = static_cast<size_t>(workspace_.steps().back().stage);
    const auto& names = workspace_.stageNames();
    if (stage < names.size())
      text = tr("Stage %1 of %2: %3").arg(stage + 1).arg(names.size()).arg(QString::fromStdString(names[stage]));
  }
  if (job.state() == JobState::paused) return text + tr("   paused");
  const auto left = job.timeLeft().seconds();
  return left ? text + tr("   %1 left").arg(numbers::duration(*left)) : text;
}

QString StepBar::outcome() const {
  if (!workspace_.document().isOpen()) return {};
  const Project& project = workspace_.document().project();
  const auto& system = workspace_.system();
  switch (workspace_.step()) {
    case Step::geometry:
      return counted(project.solids.size(), "solid");
    case Step::joints:
      return counted(project.joints.size(), "joint") + QStringLiteral(", ") + counted(project.cuts.size(), "cut");
    case Step::blocks: {
      if (!system) return tr("not cut yet");
      double volume = 0;
      for (const auto& block : system->blocks) volume += block.volume;
      return tr("%1, %2 m³").arg(counted(system->blocks.size(), "block"), numbers::significant(volume, 4));
    }
    case Step::mesh: {
      if (!system) return tr("not meshed yet");
      size_t nodes = 0, tetrahedra = 0;
      for (const auto& block : system->blocks) {
        nodes += block.mesh.nodes.size();
        tetrahedra += block.mesh.tetrahedra.size();
      }
      return tr("%1 tetrahedra, %2 nodes").arg(count(tetrahedra), count(nodes));
    }
    case Step::materials:
      return counted(project.materials.size(), "material");
    case Step::loads:
      return tr("gravity %1 m/s², %2, %3")
          .arg(numbers::significant(project.gravity.norm()), counted(project.loads.size(), "load"),
               counted(project.constraints.size(), "support"));
    case Step::stages: {
      double seconds = 0;
      for (const auto& stage : project.stages)
        seconds += stage.duration.value_or(stage.steps.value_or(0) * stage.time_step);
      return tr("%1, %2 s").arg(counted(project.stages.size(), "stage"), numbers::significant(seconds, 4));
    }
    case Step::solve:
      return runOutcome();
    case Step::results:
      break;
  }
  if (workspace_.frameTimes().empty()) return tr("nothing has been solved yet");
  const QString frames = counted(workspace_.frameTimes().size(), "frame");
  return workspace_.resultsAreCurrent() ? frames : tr("%1, of the project before it was edited").arg(frames);
}

void StepBar::refreshOutcome() {
  outcome_->setText(outcome());
  const bool busy = workspace_.job().isBusy();
  bar_->setVisible(busy);
  if (busy) bar_->setValue(static_cast<int>(1000 * workspace_.fraction()));
}

QAction* StepBar::primaryAction() const {
  const bool busy = workspace_.job().isBusy();
  switch (workspace_.step()) {
    case Step::solve:
      return busy ? actions_.pause : actions_.solve;
    case Step::results:
      return actions_.saveFilm;
    default:
      return workspace_.system() ? actions_.steps.at(Step::solve) : actions_.mesh;
  }
}

void StepBar::refreshPrimary() {
  const QAction* action = primaryAction();
  const bool leads = action == actions_.steps.at(Step::solve);
  static const std::pair<QAction * WindowActions::*, const char*> icons[] = {
      {&WindowActions::mesh, "cut"}, {&WindowActions::solve, "play"}, {&WindowActions::saveFilm, "film"}};
  QString icon = leads ? QStringLiteral("arrow-right") : QStringLiteral("pause");
  for (const auto& [member, name] : icons)
    if (actions_.*member == action) icon = QLatin1String(name);
  if (action == actions_.pause && workspace_.job().state() == JobState::paused) icon = QStringLiteral("play");
  primary_->setIcon(theme::icon(icon, theme::Tone::onAccent));
  primary_->setText(leads ? tr("Go to solve") : action->text().remove(u'…'));
  primary_->setEnabled(action->isEnabled());
  primary_->setToolTip(action->toolTip());
}

}  // namespace talus
