#include "widgets/run/run_panel.hpp"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>

#include "jobs/solver_job.hpp"
#include "model/stage_length.hpp"
#include "session/current_project.hpp"
#include "session/current_run.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/run/cost_ahead.hpp"
#include "widgets/run/effect_list.hpp"
#include "widgets/run/step_facts.hpp"
#include "widgets/run/trouble_panel.hpp"
#include "widgets/study/accuracy_slider.hpp"

namespace talus {

namespace {

QString stateWords(JobState state, const CurrentRun& run) {
  switch (state) {
    case JobState::meshing:
      return QObject::tr("cutting and meshing");
    case JobState::running:
      return QObject::tr("running");
    case JobState::paused:
      return QObject::tr("paused");
    case JobState::stopping:
      return QObject::tr("stopping after this step");
    case JobState::idle:
      break;
  }
  const QString shortfall = run.shortfall();
  if (!run.report() || !shortfall.isEmpty()) return shortfall;
  return QObject::tr("finished");
}

/// How a run ended that did not complete.
QString endWords(RunStatus status) {
  if (status == RunStatus::stopped) return QObject::tr("stopped");
  return status == RunStatus::not_converged ? QObject::tr("not converged") : QObject::tr("broken off");
}

/// Of model time, by a run that has ended.
double shareOf(const RunReport& report, const std::vector<StepReport>& steps, const Project& project) {
  double whole = 0;
  for (const Stage& stage : project.stages) whole += length_of(stage);
  if (report.status == RunStatus::completed || whole <= 0) return 1;
  return steps.empty() ? 0 : std::min(1.0, steps.back().time / whole);
}

}  // namespace

RunPanel::RunPanel(CurrentProject& project, CurrentRun& run, ProjectStudy& study, Display& display)
    : project_(project), run_(run), header_(new PanelHeader(tr("Run"))) {
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  column->addWidget(header_);
  auto* content = new QWidget;
  auto* inner = new QVBoxLayout(content);
  inner->setContentsMargins(12, 10, 12, 10);
  inner->setSpacing(6);

  auto* top = new QHBoxLayout;
  percent_ = makeLabel({}, "display");
  top->addWidget(percent_);
  top->addStretch();
  auto* times = new QVBoxLayout;
  setMargins(times, 0, 0);
  left_ = makeLabel({}, "strong");
  spent_ = makeLabel({}, "small");
  times->addWidget(left_, 0, Qt::AlignRight);
  times->addWidget(spent_, 0, Qt::AlignRight);
  top->addLayout(times);
  inner->addLayout(top);
  bar_ = makeProgressBar();
  bar_->setAccessibleName(tr("Share of the run that is done"));
  inner->addWidget(bar_);

  goOn_ = makeButton({});
  goOn_->setAccessibleName(tr("Go on with the run"));
  goOn_->setObjectName(QStringLiteral("goOn"));
  goOn_->setToolTip(tr("Takes the run up where it was stopped, to the same numbers as if it had never been"));
  inner->addWidget(goOn_);

  inner->addWidget(new StepFacts(project_, run_));
  auto* whole = new QWidget;
  auto* sections = new QVBoxLayout(whole);
  setMargins(sections, 0, 0);
  sections->addWidget(new CostAhead(project_, run_));
  sections->addWidget(new AccuracySlider(project_, run_, study));
  sections->addWidget(content);
  sections->addWidget(new TroublePanel(run_, display));
  sections->addWidget(makeLine(Qt::Horizontal));
  auto* costs = new QWidget;
  auto* list = new QVBoxLayout(costs);
  list->setContentsMargins(12, 10, 12, 10);
  list->addWidget(new EffectList(run_));
  sections->addWidget(costs);
  sections->addStretch();
  column->addWidget(makeScrolled(whole), 1);

  connect(&run_, &CurrentRun::progressed, this, &RunPanel::refresh);
  connect(&run_, &CurrentRun::historyChanged, this, &RunPanel::refresh);
  connect(&run_.job(), &SolverJob::stateChanged, this, &RunPanel::refresh);
  connect(&run_, &CurrentRun::reportChanged, this, &RunPanel::refresh);
  connect(&run_, &CurrentRun::checkpointChanged, this, &RunPanel::refresh);
  connect(&run_, &CurrentRun::outsideChanged, this, &RunPanel::refresh);
  connect(goOn_, &QPushButton::clicked, &run_, &CurrentRun::goOn);
  refresh();
}

void RunPanel::refresh() {
  const SolverJob& job = run_.job();
  const auto& report = run_.report();
  const bool outside = run_.outside().isOn(), busy = job.isBusy() || outside;
  header_->setTitle(tr("Run"), outside ? tr("goes on in the background") : stateWords(job.state(), run_));
  const double fraction = busy     ? run_.fraction()
                          : report ? shareOf(*report, run_.steps(), project_.document().project())
                                   : 0;
  percent_->setText(busy || report ? tr("%1 %").arg(static_cast<int>(100 * fraction)) : QStringLiteral("–"));
  if (!busy && report && report->status != RunStatus::completed) percent_->setText(endWords(report->status));
  showShare(*bar_, fraction);
  goOn_->setVisible(!busy && run_.checkpoint() && run_.whyNotSolve().isEmpty());
  if (run_.checkpoint()) goOn_->setText(tr("Go on from %1 s").arg(QString::number(*run_.checkpoint(), 'g', 4)));
  const auto left = job.timeLeft().seconds();
  if (outside) {
    left_->setText(tr("at %1 s").arg(numbers::fixed(run_.outside().time(), 2)));
    spent_->setText(run_.outside().canStop() ? tr("Stop ends it after its step") : run_.whyNotStop());
  } else if (busy) {
    left_->setText(left && job.state() != JobState::paused ? tr("%1 left").arg(numbers::duration(*left)) : QString());
    spent_->setText(tr("%1 spent").arg(numbers::duration(job.timeLeft().spent())));
  } else {
    left_->setText(report ? numbers::duration(report->wall_seconds) : QString());
    spent_->setText(report                 ? numbers::counted(report->threads, "thread")
                    : run_.steps().empty() ? tr("not run yet")
                                           : tr("from results"));
  }
}

}  // namespace talus
