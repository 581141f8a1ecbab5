#include "widgets/run_panel.hpp"

#include <algorithm>

#include "model/stage_length.hpp"
#include "widgets/accuracy_slider.hpp"
#include "widgets/cost_ahead.hpp"
#include "widgets/effect_list.hpp"
#include "widgets/numbers.hpp"
#include "widgets/step_facts.hpp"
#include "widgets/struggle_panel.hpp"

namespace talus {

namespace {

QString stateWords(JobState state, const std::optional<RunReport>& report) {
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
  if (!report) return {};
  switch (report->status) {
    case RunStatus::completed:
      return QObject::tr("finished");
    case RunStatus::stopped:
      return QObject::tr("stopped");
    case RunStatus::not_converged:
      return QObject::tr("did not converge");
  }
  return {};
}

/// Of model time, by a run that has ended.
double shareOf(const RunReport& report, const std::vector<StepReport>& steps, const Project& project) {
  double whole = 0;
  for (const Stage& stage : project.stages) whole += length_of(stage);
  if (report.status == RunStatus::completed || whole <= 0) return 1;
  return steps.empty() ? 0 : std::min(1.0, steps.back().time / whole);
}

}  // namespace

RunPanel::RunPanel(Workspace& workspace) : workspace_(workspace), header_(new PanelHeader(tr("Run"))) {
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
  bar_ = new QProgressBar;
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  bar_->setAccessibleName(tr("Share of the run that is done"));
  inner->addWidget(bar_);

  inner->addWidget(new StepFacts(workspace_));
  auto* whole = new QWidget;
  auto* sections = new QVBoxLayout(whole);
  setMargins(sections, 0, 0);
  sections->addWidget(new CostAhead(workspace_));
  sections->addWidget(new AccuracySlider(workspace_));
  sections->addWidget(content);
  sections->addWidget(new StrugglePanel(workspace_));
  sections->addWidget(makeLine(Qt::Horizontal));
  auto* costs = new QWidget;
  auto* list = new QVBoxLayout(costs);
  list->setContentsMargins(12, 10, 12, 10);
  list->addWidget(new EffectList(workspace_));
  sections->addWidget(costs);
  sections->addStretch();
  column->addWidget(makeScrolled(whole), 1);

  connect(&workspace_, &Workspace::progressed, this, &RunPanel::refresh);
  connect(&workspace_, &Workspace::historyChanged, this, &RunPanel::refresh);
  connect(&workspace_.job(), &SolverJob::stateChanged, this, &RunPanel::refresh);
  connect(&workspace_, &Workspace::reportChanged, this, &RunPanel::refresh);
  refresh();
}

void RunPanel::refresh() {
  const SolverJob& job = workspace_.job();
  const auto& report = workspace_.report();
  header_->setTitle(tr("Run"), stateWords(job.state(), report));
  const bool busy = job.isBusy();
  const double fraction = busy     ? workspace_.fraction()
                          : report ? shareOf(*report, workspace_.steps(), workspace_.document().project())
                                   : 0;
  percent_->setText(busy || report ? tr("%1 %").arg(static_cast<int>(100 * fraction)) : QStringLiteral("–"));
  if (!busy && report && report->status != RunStatus::completed)
    percent_->setText(report->status == RunStatus::stopped ? tr("stopped") : tr("not converged"));
  bar_->setValue(static_cast<int>(1000 * fraction));
  const auto left = job.timeLeft().seconds();
  if (busy) {
    left_->setText(left && job.state() != JobState::paused ? tr("%1 left").arg(numbers::duration(*left)) : QString());
    spent_->setText(tr("%1 spent").arg(numbers::duration(job.timeLeft().spent())));
  } else {
    left_->setText(report ? numbers::duration(report->wall_seconds) : QString());
    spent_->setText(report                       ? numbers::counted(report->threads, "thread")
                    : workspace_.steps().empty() ? tr("not run yet")
                                                 : tr("from results"));
  }
}

}  // namespace talus
