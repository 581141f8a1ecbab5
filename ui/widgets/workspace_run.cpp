// The run of the workspace: it starts, brings news, ends, and leaves results.
#include "base/error.hpp"
#include "io/project_file.hpp"
#include "widgets/numbers.hpp"
#include "widgets/workspace.hpp"

namespace talus {

namespace {

/// Of a run that did not converge: in words, and as the place that the view can go to.
Problem problemOf(const RunReport& report) {
  Problem problem{Problem::Severity::warning,
                  QObject::tr("run"),
                  QString::fromStdString(report.reason),
                  QObject::tr("the results hold until then"),
                  {}};
  if (!report.struggles.empty() && report.struggles.front().ended_run) problem.where = report.struggles.front();
  return problem;
}

}  // namespace

void Workspace::start(bool solve) {
  loader_.close();
  forgetResults();
  std::erase_if(problems_, [](const Problem& problem) { return problem.where.has_value(); });  // of the run before
  emit problemsChanged();
  if (!systemIsCurrent()) setSystem(nullptr);
  builtFrom_ = document_.project();
  namesFromProject();
  JobTask task;
  task.project = document_.project();
  task.folder = document_.folder();
  task.options.out = document_.resultsFolder();
  task.options.project_text = write_project(document_.project());
  task.system = system_;
  task.solve = solve;
  live_ = solve;
  resultsAreCurrent_ = solve;
  following_ = true;
  log(solve ? tr("run started") : tr("cutting and meshing"));
  job_.start(std::move(task));
}

void Workspace::takeNews(const JobNews& news) {
  fraction_ = news.fraction;
  activity_ = QString::fromStdString(news.what);
  if (news.system) {
    setSystem(news.system);
    log(tr("%1 cut and meshed").arg(numbers::counted(static_cast<long long>(news.system->blocks.size()), "block")));
  }
  if (news.size) size_ = news.size;
  if (!news.effects.empty()) effects_ = news.effects;
  if (news.size || !news.effects.empty()) emit effectsChanged();
  if (!news.struggles.empty()) takeStruggles(news.struggles);
  if (!news.frames.empty()) {
    for (const auto& frame : news.frames) liveFrames_.add(frame);
    times_.clear();
    for (const auto& frame : liveFrames_.frames()) times_.push_back(frame->time);
    emit framesChanged();
    if (following_) showFrame(static_cast<int>(times_.size()) - 1);
  }
  if (!news.steps.empty()) {
    steps_.insert(steps_.end(), news.steps.begin(), news.steps.end());
    history_.insert(history_.end(), news.history.begin(), news.history.end());
    emit historyChanged();
  }
  emit progressed();
}

void Workspace::takeEnd(const JobEnd& end) {
  const bool failed = end.kind == JobEnd::Kind::failed;
  switch (end.kind) {
    case JobEnd::Kind::meshed:
      break;
    case JobEnd::Kind::completed:
      log(tr("run finished"));
      break;
    case JobEnd::Kind::stopped:
      log(tr("run stopped; its results stay"));
      break;
    case JobEnd::Kind::cancelled:
      log(tr("cancelled"));
      break;
    case JobEnd::Kind::notConverged:
      addProblem(problemOf(*end.report));
      break;
    case JobEnd::Kind::failed:
      addProblem({Problem::Severity::error, QString::fromStdString(end.place), QString::fromStdString(end.problem),
                  QString::fromStdString(end.remedy)});
      break;
  }
  if (end.report) {
    report_ = end.report;
    events_ = end.report->events;
    effects_ = end.report->effects;
    takeStruggles(end.report->struggles);
    emit reportChanged();
    emit effectsChanged();
  }
  live_ = live_ && !failed && end.kind != JobEnd::Kind::cancelled;
  if (!end.results.empty()) {
    wantedTime_ = frame_ ? std::optional<double>(frame_->time) : std::nullopt;
    loadResults(end.results);
  }
  emit progressed();
}

void Workspace::loadResults(const std::filesystem::path& folder) {
  loading_ = true;
  loader_.open(folder);
}

void Workspace::takeIndex(const ResultsIndex& index) {
  const bool afterRun = wantedTime_.has_value();
  live_ = loading_ = false;
  liveFrames_.clear();
  resultsFolder_ = index.folder;
  if (!afterRun) setSystem(index.system);
  times_ = index.frame_times;
  stageNames_ = index.stage_names;
  monitorNames_ = index.monitor_names;
  steps_ = index.steps;
  history_ = index.history;
  if (!afterRun) report_ = index.report;
  events_ = report_ ? report_->events : std::vector<Event>();
  effects_ = report_ ? report_->effects : std::vector<EffectOutcome>();
  takeStruggles(report_ ? report_->struggles : std::vector<Struggle>());
  number_ = -1;
  emit framesChanged();
  emit historyChanged();
  emit reportChanged();
  emit effectsChanged();
  if (afterRun)
    showTime(*wantedTime_);
  else
    showFrame(static_cast<int>(times_.size()) - 1);
  wantedTime_.reset();
  if (!afterRun || step_ == Step::solve) goTo(Step::results);
}

void Workspace::takeStruggles(const std::vector<Struggle>& struggles) {
  struggles_ = struggles;
  emit strugglesChanged();
}

void Workspace::showStruggle(const Struggle& struggle) {
  std::vector<int> blocks;
  for (std::size_t b = 0; system_ && b < system_->blocks.size(); ++b)
    for (const std::string& name : struggle.blocks)
      if (system_->blocks[b].name == name) blocks.push_back(static_cast<int>(b));
  selection().selectBlocks(std::move(blocks));
  emit struggleWanted(struggle);
}

}  // namespace talus
