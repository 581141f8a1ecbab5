#include "widgets/window/workflow_bar.hpp"

#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>

#include "document/item_at.hpp"
#include "geometry/solid_surface.hpp"
#include "jobs/solver_job.hpp"
#include "mesh/volume_sum.hpp"
#include "model/stage_length.hpp"
#include "session/session.hpp"
#include "widgets/actions/load_actions.hpp"
#include "widgets/blocks/block_view_tools.hpp"
#include "widgets/geometry/solid_tools.hpp"
#include "widgets/joints/joint_actions.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/view/field_chooser.hpp"
#include "widgets/window/top_bar.hpp"

namespace talus {

namespace {

constexpr double told_seconds = 2;  // time left that is worth a word

QHBoxLayout* makeRow(QWidget* page) {
  auto* row = new QHBoxLayout(page);
  setMargins(row, 0, 2);
  return row;
}

/// A button that opens a menu.
template <class Fill>
void addChoices(QHBoxLayout& row, const char* icon, const QString& words, const QString& tip, const Fill& fill) {
  auto* button = makeAction(QLatin1String(icon), words, tip);
  auto* menu = new QMenu(words, button);
  menu->setToolTipsVisible(true);
  fill(*menu);
  button->setMenu(menu);
  button->setPopupMode(QToolButton::InstantPopup);
  row.addWidget(button);
}

}  // namespace

WorkflowBar::WorkflowBar(Session& session, WindowActions& actions) : session_(session), actions_(actions) {
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
  for (const WorkflowPage page : all_pages)
    if (isSetUp(page)) pages_->addWidget(makeSetUpPage(page));
  pages_->addWidget(makeSolvePage());
  pages_->addWidget(makeResultsPage());
  row->addWidget(pages_);
  outcome_ = new ElidedLabel({}, "small");
  outcome_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(outcome_, 1);
  bar_ = makeProgressBar();
  bar_->setFixedWidth(120);
  row->addWidget(bar_);
  primary_ = makeButton({}, "primary");
  primary_->setObjectName(QStringLiteral("primary"));
  connect(primary_, &QPushButton::clicked, this, [this] { primaryAction()->trigger(); });
  row->addWidget(primary_);

  connect(&session_.display, &Display::pageChanged, this, &WorkflowBar::refresh);
  connect(&session_.project, &CurrentProject::opened, this, &WorkflowBar::refresh);
  connect(&session_.project, &CurrentProject::systemChanged, this, &WorkflowBar::refresh);
  connect(&session_.project.document(), &Document::projectChanged, this, &WorkflowBar::refresh);
  connect(&session_.project.problems(), &ProjectProblems::changed, this, &WorkflowBar::refresh);
  connect(&session_.surfaces, &SolidSurfaces::changed, this, &WorkflowBar::refreshOutcome);
  connect(&session_.playback, &Playback::framesChanged, this, &WorkflowBar::refresh);
  connect(&session_.run, &CurrentRun::reportChanged, this, &WorkflowBar::refresh);
  connect(&session_.run, &CurrentRun::progressed, this, &WorkflowBar::refreshOutcome);
  connect(&session_.run, &CurrentRun::outsideChanged, this, &WorkflowBar::refresh);
  connect(&session_.run.job(), &SolverJob::stateChanged, this, &WorkflowBar::refresh);
  for (auto* action : {actions_.mesh, actions_.solve, actions_.pause, actions_.stop, actions_.saveFilm})
    connect(action, &QAction::changed, this, &WorkflowBar::refreshPrimary);
  refresh();
}

QWidget* WorkflowBar::makeSetUpPage(WorkflowPage page) {
  auto* strip = new QWidget;
  auto* row = makeRow(strip);
  if (page == WorkflowPage::joints) {
    addJointActions(*row);
  } else if (page == WorkflowPage::loads) {
    addLoadActions(*row);
  } else {
    if (page == WorkflowPage::geometry)
      addGeometryActions(*row);
    else
      row->addWidget(makeActionButton(actions_.mesh, true));
    row->addWidget(makeActionButton(actions_.fit, true));
    row->addWidget(makeActionButton(actions_.savePicture, true));
  }
  if (page == WorkflowPage::blocks || page == WorkflowPage::mesh) {
    row->addSpacing(8);
    row->addWidget(new BlockViewTools(session_.colouring, session_.display));
  }
  row->addStretch();
  return strip;
}

void WorkflowBar::addGeometryActions(QHBoxLayout& row) {
  const SolidTools& solids = *actions_.solids;
  row.addWidget(makeActionButton(solids.importGeometry, true));
  addChoices(row, "plus", tr("New"), tr("New solid"), [&](QMenu& menu) { solids.addNew(menu); });
  addChoices(row, "vectors", tr("Change"), tr("Move, turn, scale, copy or combine the selected solids"),
             [&](QMenu& menu) { solids.addChanges(menu); });
  row.addWidget(makeActionButton(solids.measure, true));
}

void WorkflowBar::addJointActions(QHBoxLayout& row) {
  for (auto* action : {actions_.joints->threePoints, actions_.joints->alongFace, actions_.joints->assignToFace,
                       actions_.pasteJoints, actions_.stereonet})
    row.addWidget(makeActionButton(action, true));
}

void WorkflowBar::addLoadActions(QHBoxLayout& row) {
  const LoadActions& loads = *actions_.loads;
  addChoices(row, "loads", tr("Load"), tr("A force on a point, a face or a block that is picked in the view"),
             [&](QMenu& menu) {
               menu.addActions({loads.loadAtPoint, loads.loadOnFace, loads.loadOnBlock});
             });
  addChoices(row, "fixed", tr("Support"), tr("A point, a face or a block that is held, picked in the view"),
             [&](QMenu& menu) {
               menu.addActions({loads.holdPoint, loads.holdFace, loads.holdBlock});
             });
  addChoices(row, "monitor", tr("Monitor"), tr("A point whose history is recorded, picked in the view"),
             [&](QMenu& menu) {
               menu.addActions({loads.monitor, loads.stressMonitor});
             });
  row.addWidget(makeActionButton(loads.velocity, true));
}

QWidget* WorkflowBar::makeSolvePage() {
  auto* page = new QWidget;
  auto* row = makeRow(page);
  row->addWidget(makeActionButton(actions_.oneStep, true));
  row->addWidget(makeActionButton(actions_.stop, true));
  auto* field = new FieldChooser(session_.display, this);
  row->addSpacing(6);
  row->addWidget(field->quantityBox());
  row->addSpacing(4);
  row->addWidget(field->componentBox());
  field->quantityBox()->setFixedWidth(116);
  field->componentBox()->setFixedWidth(116);
  showWithField(*field->componentBox());
  row->addStretch();
  return page;
}

QWidget* WorkflowBar::makeResultsPage() {
  auto* page = new QWidget;
  auto* row = makeRow(page);
  auto* field = new FieldChooser(session_.display, this);
  field->quantityBox()->setFixedWidth(136);
  field->quantityBox()->setObjectName(QStringLiteral("field"));
  field->componentBox()->setFixedWidth(136);
  row->addWidget(field->quantityBox());
  row->addSpacing(4);
  row->addWidget(field->componentBox());
  showWithField(*field->componentBox());
  row->addSpacing(8);
  row->addWidget(makeActionButton(actions_.savePicture, true));
  row->addWidget(makeActionButton(actions_.solve, true));
  row->addStretch();
  return page;
}

/// A component there is none of takes no room.
void WorkflowBar::showWithField(QWidget& box) {
  const auto follow = [this, &box] { box.setVisible(session_.display.settings().field.has_value()); };
  connect(&session_.display, &Display::changed, &box, follow);
  follow();
}

void WorkflowBar::refresh() {
  const WorkflowPage page = session_.display.page();
  title_->setText(pageTitle(page));
  pages_->setCurrentIndex(static_cast<int>(page));
  refreshOutcome();
  refreshPrimary();
}

QString WorkflowBar::runOutcome() const {
  const SolverJob& job = session_.run.job();
  if (session_.run.outside().isOn())
    return tr("In the background: %1 s").arg(numbers::fixed(session_.run.outside().time(), 2));
  if (!job.isBusy()) {
    const auto& report = session_.run.report();
    if (!report) return session_.run.whyNotSolve();
    const QString shortfall = session_.run.shortfall();
    QString length =
        tr("%1 in %2").arg(numbers::counted(report->steps, "step"), numbers::duration(report->wall_seconds));
    if (!shortfall.isEmpty()) length = tr("%1; %2").arg(sentenceCase(shortfall), length);
    return session_.playback.isCurrent() ? length : tr("edited since; %1").arg(length);
  }
  if (job.state() == JobState::meshing) return cuttingOutcome();
  if (job.state() == JobState::stopping)
    return session_.project.system() ? tr("Stopping after this step") : tr("Stopping");
  QString words;
  if (!session_.run.steps().empty()) {
    const auto stage = static_cast<size_t>(session_.run.steps().back().stage);
    const auto& names = session_.run.stageNames();
    if (stage < names.size()) words = tr("Stage %1 of %2: %3").arg(stage + 1).arg(names.size()).arg(text(names[stage]));
  }
  if (job.state() == JobState::paused) return words + tr("   paused");
  const auto left = job.timeLeft().seconds();
  return left ? words + tr("   %1 left").arg(numbers::duration(*left)) : words;
}

QString WorkflowBar::cuttingOutcome() const {
  const auto left = session_.run.job().timeLeft().seconds();
  return left && *left > told_seconds ? tr("Cutting and meshing, %1 left").arg(numbers::duration(*left))
                                      : tr("Cutting and meshing");
}

QString WorkflowBar::ofBlocks(const QString& words) const {
  return session_.project.systemIsCurrent() ? words : tr("%1, before the last change").arg(words);
}

QString WorkflowBar::solidsOutcome() const {
  const QString count = numbers::counted(session_.project.document().project().solids.size(), "solid");
  const SolidSurfaces& solids = session_.surfaces;
  if (solids.isBusy()) return tr("%1, being read").arg(count);
  if (!solids.problems().empty()) {
    const Problem first = problemOf(solids.problems().front());
    return tr("%1; %2: %3").arg(count, placeWords(session_.project.document().project(), first.place), first.problem);
  }
  double volume = 0;
  for (std::size_t i = 0; solids.current() && i < solids.current()->size(); ++i)
    volume += (*solids.current())[i].volume;
  return volume > 0 ? tr("%1, %2 m³").arg(count, numbers::significant(volume, 4)) : count;
}

QString WorkflowBar::outcome() const {
  if (!session_.project.document().isOpen()) return {};
  if (session_.run.job().state() == JobState::meshing) return cuttingOutcome();
  const Project& project = session_.project.document().project();
  const auto& system = session_.project.system();
  switch (session_.display.page()) {
    case WorkflowPage::geometry:
      return solidsOutcome();
    case WorkflowPage::joints:
      return numbers::counted(project.joints.size(), "joint") + QStringLiteral(", ") +
             numbers::counted(project.cuts.size(), "cut");
    case WorkflowPage::blocks: {
      if (!system) return tr("not cut yet");
      const VolumeSum volume = volume_sum(*system);
      return ofBlocks(tr("%1, %2 m³ of %3 m³")
                          .arg(numbers::counted(system->blocks.size(), "block"), numbers::figure(volume.blocks, 6),
                               numbers::figure(volume.solids, 6)));
    }
    case WorkflowPage::mesh: {
      if (!system) return tr("not meshed yet");
      size_t nodes = 0, tetrahedra = 0;
      for (const auto& block : system->blocks) {
        nodes += block.mesh.nodes.size();
        tetrahedra += block.mesh.tetrahedra.size();
      }
      return ofBlocks(tr("%1 tetrahedra, %2 nodes").arg(numbers::whole(tetrahedra), numbers::whole(nodes)));
    }
    case WorkflowPage::materials:
      return numbers::counted(project.materials.size(), "material");
    case WorkflowPage::loads:
      return tr("gravity %1 m/s², %2, %3")
          .arg(numbers::significant(project.gravity.norm()), numbers::counted(project.loads.size(), "load"),
               numbers::counted(project.constraints.size(), "support"));
    case WorkflowPage::stages: {
      double seconds = 0;
      for (const auto& stage : project.stages) seconds += length_of(stage);
      return tr("%1, %2 s").arg(numbers::counted(project.stages.size(), "stage"), numbers::significant(seconds, 4));
    }
    case WorkflowPage::solve:
      return runOutcome();
    case WorkflowPage::results:
      break;
  }
  if (session_.playback.times().empty()) return tr("nothing has been solved yet");
  const QString frames = numbers::counted(session_.playback.times().size(), "frame");
  if (!session_.playback.isCurrent()) return tr("%1, of the project before it was edited").arg(frames);
  const QString shortfall = session_.run.job().isBusy() ? QString() : session_.run.shortfall();
  return shortfall.isEmpty() ? frames : tr("%1; %2").arg(sentenceCase(shortfall), frames);
}

void WorkflowBar::refreshOutcome() {
  outcome_->setText(outcome());
  const bool busy = session_.run.isBusy() || session_.run.outside().isOn();
  bar_->setVisible(busy);
  if (busy) showShare(*bar_, session_.run.fraction());
}

QAction* WorkflowBar::primaryAction() const {
  const bool busy = session_.run.job().isBusy();
  switch (session_.display.page()) {
    case WorkflowPage::solve:
      return busy ? actions_.pause : actions_.solve;
    case WorkflowPage::results:
      return actions_.saveFilm;
    default:
      if (session_.run.job().state() == JobState::meshing) return actions_.stop;
      return session_.project.systemIsCurrent() ? actions_.pages.at(WorkflowPage::solve) : actions_.mesh;
  }
}

void WorkflowBar::refreshPrimary() {
  const QAction* action = primaryAction();
  const bool leads = action == actions_.pages.at(WorkflowPage::solve);
  static const std::pair<QAction * WindowActions::*, const char*> icons[] = {
      {&WindowActions::mesh, "cut"}, {&WindowActions::solve, "play"}, {&WindowActions::saveFilm, "film"}};
  QString icon = leads ? QStringLiteral("arrow-right") : QStringLiteral("pause");
  for (const auto& [member, name] : icons)
    if (actions_.*member == action) icon = QLatin1String(name);
  if (action == actions_.pause && session_.run.job().state() == JobState::paused) icon = QStringLiteral("play");
  if (action == actions_.stop) icon = QStringLiteral("stop");
  primary_->setIcon(theme::icon(icon, theme::Tone::onAccent));
  primary_->setText(leads ? tr("Go to solve") : action == actions_.stop ? tr("Cancel") : action->text().remove(u'…'));
  primary_->setEnabled(action->isEnabled());
  primary_->setToolTip(action->toolTip());
}

}  // namespace talus
