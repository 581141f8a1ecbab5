#include "session/current_run.hpp"

#include <algorithm>
#include <utility>

#include "document/schema.hpp"
#include "io/project_change.hpp"
#include "jobs/results_loader.hpp"
#include "jobs/solver_job.hpp"
#include "mesh/volume_sum.hpp"
#include "model/stage_length.hpp"
#include "render/paint/numbers.hpp"
#include "results/summary.hpp"
#include "session/current_project.hpp"
#include "session/messages.hpp"
#include "session/playback.hpp"

namespace talus {

namespace {

/// Of a run that did not converge: in words, and as the place that the view can go to.
Problem problemOf(const RunReport& report) {
  Problem problem{.severity = Problem::Severity::warning,
                  .place = QObject::tr("run"),
                  .problem = schema::inWordsOfForms(QString::fromStdString(report.reason)),
                  .remedy = QObject::tr("the results hold until then"),
                  .of = Problem::Of::run};
  if (!report.troubles.empty() && report.troubles.front().ended_run) problem.where = report.troubles.front();
  return problem;
}

QString number(double value) { return QString::fromStdString(format_number(value, 4)); }

/// Of an expected value that did not come out.
Problem problemOf(const ExpectationOutcome& outcome) {
  const Expectation& expected = outcome.expectation;
  const QString wanted = QObject::tr("%1 was expected at %2 s, within %3")
                             .arg(number(expected.value), number(expected.time), number(expected.tolerance));
  return {.severity = Problem::Severity::warning,
          .place = QString::fromStdString(expected.quantity),
          .problem = outcome.reached ? QObject::tr("is %1; %2").arg(number(outcome.computed), wanted)
                                     : QObject::tr("was not reached by the run; %1").arg(wanted),
          .remedy = QObject::tr("see how it went in the histories, and which of project and expectation is wrong"),
          .of = Problem::Of::run};
}

/// Of rock that cutting has lost or made twice.
Problem problemOf(const VolumeSum& sum) {
  return {.severity = Problem::Severity::warning,
          .place = QObject::tr("blocks"),
          .problem = QObject::tr("they and what was left out have %1 m³ together, the solids %2 m³")
                         .arg(number(sum.blocks + sum.left_out), number(sum.solids)),
          .remedy = QObject::tr("look for solids that are open or overlap, and for cuts that nearly meet"),
          .of = Problem::Of::run};
}

/// Of pieces that are too thin to be blocks; their list tells where each is.
Problem problemOf(const std::vector<Splinter>& splinters) {
  const double thinnest = std::ranges::min(splinters, {}, &Splinter::thickness).thickness;
  return {.place = QObject::tr("blocks"),
          .problem = splinters.size() == 1 ? QObject::tr("the cuts leave a splinter, %1 m thick").arg(number(thinnest))
                                           : QObject::tr("the cuts leave %1 splinters, the thinnest %2 m thick")
                                                 .arg(splinters.size())
                                                 .arg(number(thinnest)),
          .remedy = QObject::tr("drop them, merge them with their neighbours, or move a joint: see Splinters"),
          .of = Problem::Of::run};
}

/// In what a run that has ended falls short; empty: in nothing.
QString shortfallOf(const RunReport& report) {
  if (report.status == RunStatus::stopped) return QObject::tr("stopped at %1 s").arg(number(report.time));
  if (report.status == RunStatus::not_converged)
    return QObject::tr("did not converge at %1 s").arg(number(report.time));
  if (report.status == RunStatus::interpenetrating)
    return QObject::tr("blocks lay in each other at %1 s").arg(number(report.time));
  const long missed = missed_expectations(report);
  if (missed == 0) return {};
  return QObject::tr("%1 of %2 expected values missed").arg(missed).arg(report.expect.size());
}

/// "1 block", "12 300 blocks".
QString countOf(const BlockSystem& system) {
  const std::size_t count = system.blocks.size();
  return (count == 1 ? QObject::tr("%1 block") : QObject::tr("%1 blocks"))
      .arg(QString::fromStdString(format_decimals(static_cast<double>(count), 0)));
}

}  // namespace

CurrentRun::CurrentRun(CurrentProject& project, Playback& playback, Messages& messages, SolverParts parts)
    : project_(project),
      playback_(playback),
      messages_(messages),
      job_(std::make_unique<SolverJob>(std::move(parts))),
      outside_(std::make_unique<OutsideRun>()) {
  connect(job_.get(), &SolverJob::stateChanged, this, [this] {
    if (leaving_ && job_->state() == JobState::running) job_->stop();
  });
  connect(outside_.get(), &OutsideRun::changed, this, &CurrentRun::takeOutside);
  connect(outside_.get(), &OutsideRun::ended, this, &CurrentRun::takeOutside);
  connect(job_.get(), &SolverJob::newsArrived, this, &CurrentRun::takeNews);
  connect(job_.get(), &SolverJob::ended, this, &CurrentRun::takeEnd);
  connect(&playback_, &Playback::resultsOpened, this, &CurrentRun::takeResults);
  connect(&project_, &CurrentProject::systemChanged, this, [this] {
    size_.reset();
    emit effectsChanged();
  });
  connect(&project_.document(), &Document::projectChanged, this, &CurrentRun::effectsChanged);
  connect(&project_.document(), &Document::projectChanged, this, &CurrentRun::findCheckpoint);
  for (const auto changed : {&Document::opened, &Document::savedChanged})
    connect(&project_.document(), changed, this, &CurrentRun::readCheckpoint);
}

CurrentRun::~CurrentRun() = default;

bool CurrentRun::isBusy() const { return job_->isBusy(); }

bool CurrentRun::canLeave() const { return job_->isBusy() && !task_.results.empty(); }

QString CurrentRun::whyNotMesh() const {
  const Document& document = project_.document();
  if (!document.isOpen()) return tr("Open a project first");
  if (job_->isBusy()) return tr("A run goes on");
  // It reads the results that a run would replace.
  if (playback_.isExporting()) return tr("The results are being exported");
  if (document.project().solids.empty()) return tr("The project has no solid");
  return {};
}

QString CurrentRun::whyNotSolve() const {
  const QString mesh = whyNotMesh();
  if (!mesh.isEmpty()) return mesh;
  if (outside_->isOn()) return tr("A run goes on in the background");
  return project_.problems().whyNotSolve();
}

void CurrentRun::mesh() {
  if (whyNotMesh().isEmpty()) start(Start::meshing);
}

void CurrentRun::solve() {
  if (whyNotSolve().isEmpty() && !project_.document().file().empty()) start(Start::run);
}

void CurrentRun::goOn() {
  if (checkpoint_ && whyNotSolve().isEmpty()) start(Start::runFromCheckpoint);
}

void CurrentRun::stop() {
  leaving_ = false;
  if (job_->isBusy()) return job_->stop();
  outside_->stop();
  if (outside_->isOn()) messages_.log(tr("asked the run in the background to stop"));
}

QString CurrentRun::whyNotStop() const {
  if (job_->isBusy() || outside_->canStop()) return {};
  return outside_->isOn() ? tr("Another window makes this run") : tr("Nothing runs");
}

void CurrentRun::leave() {
  leaving_ = true;
  if (job_->state() != JobState::meshing) job_->stop();
}

double CurrentRun::fraction() const {
  if (!outside_->isOn()) return fraction_;
  double whole = 0;
  for (const Stage& stage : project_.document().project().stages) whole += length_of(stage);
  return whole > 0 ? std::min(1.0, outside_->time() / whole) : 0;
}

/// Where its results are open they are read anew now and then, and at its end.
void CurrentRun::takeOutside() {
  constexpr int looks_between = 10;  // a second each
  const bool isOver = !outside_->isOn();
  if (isOver) {
    messages_.log(tr("the run in the background has ended"));
    readCheckpoint();
  }
  const bool isDue = isOver || (++looks_ % looks_between == 0 && !playback_.isLoading());
  if (isDue && playback_.folder() == outside_->folder()) {
    report_.reset();
    playback_.readAgain();
  }
  emit outsideChanged();
  emit progressed();
}

/// A run beside the project, or into the results that are open.
void CurrentRun::watchOutside() {
  const Document& document = project_.document();
  outside_->watch(document.file().empty() ? playback_.folder() : document.resultsFolder());
}

void CurrentRun::clear() {
  fraction_ = 0;
  iterations_ = 0;
  activity_.clear();
  steps_.clear();
  history_.clear();
  events_.clear();
  stageNames_.clear();
  monitorNames_.clear();
  const Project& project = project_.document().project();
  for (const auto& stage : project.stages) stageNames_.push_back(stage.name);
  for (const auto& monitor : project.monitors) monitorNames_.push_back(monitor.name);
  report_.reset();
  effects_.clear();
  takeTroubles({});
  emit historyChanged();
  emit reportChanged();
  emit effectsChanged();
}

void CurrentRun::start(Start what) {
  const bool solve = what != Start::meshing;
  playback_.clear();
  clear();
  messages_.settle(Problem::Of::run);
  messages_.settle(Problem::Of::results);
  project_.beginBuilding(!solve || !project_.systemIsCurrent());
  const Document& document = project_.document();
  JobTask task;
  task.project = document.project();
  task.folder = document.folder();
  task.options.out = document.resultsFolder();
  task.options.project_text = document.text();
  task.options.resume = what == Start::runFromCheckpoint;
  task.system = project_.system();
  task.solve = solve;
  task_ = solve ? OutsideTask{task.options.project_text, task.folder, task.options.out} : OutsideTask{};
  if (task.options.resume) {
    const ResultsIndex before = read_results_index(task.options.out);
    steps_ = before.steps;
    history_ = before.history;
    emit historyChanged();
  }
  if (solve) playback_.beginRun();
  messages_.log(task.options.resume ? tr("run goes on from %1 s").arg(number(*checkpoint_))
                : solve             ? tr("run started")
                                    : tr("cutting and meshing"));
  job_->start(std::move(task));
}

void CurrentRun::takeNews(const JobNews& news) {
  fraction_ = news.fraction;
  activity_ = QString::fromStdString(news.what);
  iterations_ = news.iterations;
  unbalanced_ = news.unbalanced;
  if (news.system) {
    project_.setSystem(news.system);
    messages_.log(tr("%1 cut and meshed").arg(countOf(*news.system)));
    if (const VolumeSum sum = volume_sum(*news.system); !sum.adds_up()) messages_.add(problemOf(sum));
  }
  if (news.size) size_ = news.size;
  if (!news.effects.empty()) effects_ = news.effects;
  if (news.size || !news.effects.empty()) emit effectsChanged();
  if (!news.troubles.empty()) takeTroubles(news.troubles);
  if (!news.frames.empty()) playback_.add(news.frames);
  if (news.moment) playback_.showMoment(news.moment);
  if (!news.steps.empty()) {
    keepStepsBefore(news);
    steps_.insert(steps_.end(), news.steps.begin(), news.steps.end());
    history_.insert(history_.end(), news.history.begin(), news.history.end());
    emit historyChanged();
  }
  emit progressed();
}

/// A run that goes on from its checkpoint takes the steps behind it again.
void CurrentRun::keepStepsBefore(const JobNews& news) {
  std::erase_if(steps_, [&](const StepReport& step) { return step.step >= news.steps.front().step; });
  std::erase_if(history_, [&](const HistoryRow& row) { return row.time >= news.history.front().time; });
}

/// Whether the project is still that of a run which was stopped or killed, or has more to come than one that is over.
bool CurrentRun::mayGoOn(const KeptRun& run, const std::string& text) {
  try {
    if (change_since_run(run.label.project_text, text)) return false;
    if (run.status == RunStatus::completed) return change_since_run(text, run.label.project_text).has_value();
  } catch (const InputError&) {
    return false;  // of a project that cannot be read any more
  }
  return run.status == RunStatus::stopped;
}

void CurrentRun::readCheckpoint() {
  const Document& document = project_.document();
  kept_.reset();
  if (document.isOpen() && !document.file().empty() && !job_->isBusy()) {
    const std::filesystem::path folder = document.resultsFolder();
    try {
      if (auto label = read_checkpoint_label(folder / "checkpoint.h5")) {
        const std::optional<RunReport> report = read_summary(folder / "summary.json");
        kept_ = {std::move(*label), report ? report->status : RunStatus::stopped};
      }
    } catch (const InputError&) {
      // Damaged: nothing goes on from there.
    }
  }
  findCheckpoint();
  watchOutside();
}

void CurrentRun::findCheckpoint() {
  const bool found = kept_ && mayGoOn(*kept_, project_.document().text());
  const std::optional<double> checkpoint = found ? std::optional(kept_->label.time) : std::nullopt;
  if (checkpoint == checkpoint_) return;
  checkpoint_ = checkpoint;
  emit checkpointChanged();
}

/// Whether another process goes on with the run that has been stopped for it.
bool CurrentRun::handOver(const JobEnd& end) {
  if (end.kind != JobEnd::Kind::stopped || end.report->reason != stopped_by_user) return false;
  try {
    goOnOutside(task_);
  } catch (const InputError& error) {
    messages_.add(problemOf(error, Problem::Of::run));
    return false;
  }
  messages_.log(tr("the run goes on in the background"));
  return true;
}

void CurrentRun::takeEnd(const JobEnd& end) {
  iterations_ = 0;
  const bool leaving = std::exchange(leaving_, false);
  const bool handed = leaving && handOver(end);
  if (leaving && (handed || end.kind != JobEnd::Kind::stopped)) emit left();
  if (handed) return playback_.endRun(end.results);
  switch (end.kind) {
    case JobEnd::Kind::meshed:
      break;
    case JobEnd::Kind::completed:
      messages_.log(missed_expectations(*end.report) == 0 ? tr("run finished")
                                                          : tr("run finished, but %1").arg(shortfallOf(*end.report)));
      break;
    case JobEnd::Kind::stopped:
      messages_.log(tr("run stopped; its results stay"));
      if (end.report->reason != stopped_by_user) messages_.add(problemOf(*end.report));
      break;
    case JobEnd::Kind::cancelled:
      messages_.log(tr("cancelled"));
      playback_.abandonRun();
      project_.abandonBuilding();
      break;
    case JobEnd::Kind::brokenOff:
      messages_.add(problemOf(*end.report));
      break;
    case JobEnd::Kind::failed:
      messages_.add(end.splinters.empty() ? problemOf(*end.failure, Problem::Of::run) : problemOf(end.splinters));
      playback_.abandonRun();
      project_.abandonBuilding();
      break;
  }
  if (end.report) takeReport(*end.report);
  if (!end.results.empty()) playback_.endRun(end.results);
  readCheckpoint();
  emit progressed();
}

void CurrentRun::takeReport(const RunReport& report) {
  report_ = report;
  events_ = report.events;
  effects_ = report.effects;
  takeTroubles(report.troubles);
  for (const ExpectationOutcome& outcome : report.expect)
    if (!outcome.passed && report.status == RunStatus::completed) messages_.add(problemOf(outcome));
  emit reportChanged();
  emit effectsChanged();
}

bool CurrentRun::isDone() const {
  return !isBusy() && report_ && report_->status == RunStatus::completed && playback_.isCurrent();
}

QString CurrentRun::shortfall() const {
  if (report_) return shortfallOf(*report_);
  return steps_.empty() ? QString() : tr("the run was not brought to its end");
}

void CurrentRun::takeTroubles(const std::vector<ConvergenceTrouble>& troubles) {
  troubles_ = troubles;
  emit troublesChanged();
}

void CurrentRun::takeResults(const ResultsIndex& index, bool afterRun) {
  if (!afterRun) project_.setSystem(index.system);
  stageNames_ = index.stage_names;
  monitorNames_ = index.monitor_names;
  steps_ = index.steps;
  history_ = index.history;
  emit historyChanged();
  if (index.report && !report_ && !outside_->isOn()) takeReport(*index.report);
  watchOutside();
}

std::vector<EffectCost> CurrentRun::effectCosts() const {
  if (!size_ || !project_.systemIsCurrent()) return {};
  return effect_costs(project_.document().project(), *project_.system(), *size_);
}

}  // namespace talus
