#include "widgets/workspace.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "geometry/block_builder.hpp"
#include "io/project_file.hpp"
#include "widgets/theme.hpp"

namespace talus {

namespace {

QString text(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

Problem problemOf(const InputError& error) {
  return {Problem::Severity::error, QString::fromStdString(error.place()), QString::fromStdString(error.problem()),
          QString::fromStdString(error.remedy())};
}

int nearest(const std::vector<double>& times, double time) {
  const auto after = std::lower_bound(times.begin(), times.end(), time);
  if (after == times.begin()) return 0;
  if (after == times.end()) return static_cast<int>(times.size()) - 1;
  const auto before = std::prev(after);
  return static_cast<int>((time - *before < *after - time ? before : after) - times.begin());
}

}  // namespace

Workspace::Workspace(SolverSteps steps, QObject* parent) : QObject(parent), job_(std::move(steps)) {
  connect(&job_, &SolverJob::newsArrived, this, &Workspace::takeNews);
  connect(&job_, &SolverJob::ended, this, &Workspace::takeEnd);
  connect(&loader_, &ResultsLoader::opened, this, [this](const auto& index) { takeIndex(*index); });
  connect(&loader_, &ResultsLoader::frameReady, this, &Workspace::takeFrame);
  connect(&loader_, &ResultsLoader::failed, this,
          [this](const QString& place, const QString& what, const QString& do_) {
            waiting_ = false;
            addProblem({Problem::Severity::error, place, what, do_});
          });
  connect(&document_, &Document::projectChanged, this, [this] {
    resultsAreCurrent_ = false;
    emit framesChanged();
    emit effectsChanged();
  });
}

bool Workspace::open(const std::filesystem::path& path) {
  if (job_.isBusy()) {
    addProblem(
        {Problem::Severity::warning, text(path), tr("a run goes on"), tr("stop it before opening another file")});
    return false;
  }
  std::error_code unreadable;  // is said by whoever opens it
  return std::filesystem::is_directory(path, unreadable) ? openResults(path) : openProject(path);
}

bool Workspace::openProject(const std::filesystem::path& file) {
  try {
    document_.open(file);
  } catch (const InputError& error) {
    Problem problem = problemOf(error);
    problem.place = text(file.filename()) + QStringLiteral(": ") + problem.place;
    addProblem(problem);
    return false;
  }
  forgetResults();
  setSystem(nullptr);
  builtFrom_ = document_.project();
  namesFromProject();
  problems_.clear();
  emit problemsChanged();
  emit projectOpened();
  log(tr("opened %1").arg(text(document_.file())));
  lookForStudy();
  const auto folder = document_.resultsFolder();
  std::error_code ignored;
  if (std::filesystem::exists(folder / "project.talus", ignored)) {
    try {
      resultsAreCurrent_ = read_project(folder / "project.talus") == document_.project();
    } catch (const InputError&) {
      resultsAreCurrent_ = false;  // results of an older program: they can still be opened as a folder
    }
  }
  if (resultsAreCurrent_)
    loadResults(folder);
  else
    goTo(Step::geometry);
  return true;
}

bool Workspace::openResults(const std::filesystem::path& folder) {
  try {
    document_.show(read_project(folder / "project.talus"));
  } catch (const InputError& error) {
    Problem problem = problemOf(error);
    problem.place = text(folder) + QStringLiteral(": ") + problem.place;
    problem.remedy = tr("open a project file, or a folder that a run has written");
    addProblem(problem);
    return false;
  }
  forgetResults();
  setSystem(nullptr);
  builtFrom_ = document_.project();
  namesFromProject();
  problems_.clear();
  resultsAreCurrent_ = true;
  emit problemsChanged();
  emit projectOpened();
  log(tr("opened results in %1").arg(text(folder)));
  lookForStudy();
  loadResults(folder);
  return true;
}

void Workspace::save() { saveAs(document_.file()); }

bool Workspace::saveAs(const std::filesystem::path& file) {
  try {
    document_.saveAs(file);
    log(tr("saved %1").arg(text(file)));
    lookForStudy();
    return true;
  } catch (const InputError& error) {
    addProblem(problemOf(error));
    return false;
  }
}

void Workspace::goTo(Step step) {
  if (step == step_) return;
  step_ = step;
  emit stepChanged();
}

QString Workspace::whyNotMesh() const {
  if (!document_.isOpen()) return tr("Open a project first");
  if (job_.isBusy()) return tr("A run goes on");
  if (exporting_) return tr("A picture or film is being written");  // it reads the results that a run would replace
  if (document_.file().empty()) return tr("Save the project first: it came out of a results folder");
  if (document_.project().solids.empty()) return tr("The project has no solid");
  return {};
}

QString Workspace::whyNotSolve() const {
  const QString mesh = whyNotMesh();
  if (!mesh.isEmpty()) return mesh;
  if (document_.project().stages.empty()) return tr("The project has no stage");
  return {};
}

void Workspace::mesh() {
  if (!whyNotMesh().isEmpty()) return;
  setSystem(nullptr);
  start(false);
}

void Workspace::solve() {
  if (!whyNotSolve().isEmpty()) return;
  start(true);
  goTo(Step::solve);
}

bool Workspace::systemIsCurrent() const { return system_ && build_alike(builtFrom_, document_.project()); }

void Workspace::forgetResults() {
  liveFrames_.clear();
  frame_.reset();
  times_.clear();
  number_ = -1;
  live_ = waiting_ = loading_ = resultsAreCurrent_ = false;
  wantedTime_.reset();
  resultsFolder_.clear();
  steps_.clear();
  history_.clear();
  events_.clear();
  report_.reset();
  effects_.clear();
  takeStruggles({});
  fraction_ = 0;
  activity_.clear();
  seen_ = {};
  display_.range.reset();
  emit framesChanged();
  emit frameChanged();
  emit historyChanged();
  emit reportChanged();
  emit effectsChanged();
}

void Workspace::namesFromProject() {
  stageNames_.clear();
  monitorNames_.clear();
  for (const auto& stage : document_.project().stages) stageNames_.push_back(stage.name);
  for (const auto& monitor : document_.project().monitors) monitorNames_.push_back(monitor.name);
}

void Workspace::setSystem(std::shared_ptr<const BlockSystem> system) {
  if (system == system_) return;
  if (selection().current().kind == Item::Kind::block) selection().clear();
  selection().hoverBlock(std::nullopt);
  system_ = std::move(system);
  size_.reset();
  emit systemChanged();
  emit effectsChanged();
}

std::vector<EffectCost> Workspace::effectCosts() const {
  if (!size_ || !systemIsCurrent()) return {};
  return effect_costs(document_.project(), *system_, *size_);
}

QString Workspace::blockName(int block) const {
  if (!system_ || block < 0 || block >= static_cast<int>(system_->blocks.size())) return {};
  return QString::fromStdString(system_->blocks[static_cast<size_t>(block)].name);
}

void Workspace::showFrame(int number) {
  if (times_.empty()) return;
  number = std::clamp(number, 0, static_cast<int>(times_.size()) - 1);
  following_ = number == static_cast<int>(times_.size()) - 1;
  number_ = number;
  if (live_) {
    takeFrame(liveFrames_.frames()[static_cast<size_t>(number)]);
  } else {
    waiting_ = true;
    loader_.requestFrame(number);
  }
}

void Workspace::showTime(double seconds) {
  if (!times_.empty()) showFrame(nearest(times_, seconds));
}

void Workspace::takeFrame(std::shared_ptr<const Frame> frame) {
  waiting_ = false;
  frame_ = std::move(frame);
  if (display_.field && system_) {
    seen_.include(field_range(*system_, *frame_, *display_.field));
    display_.range = rangeFollowsRun_ && !seen_.empty()
                         ? std::optional<ValueRange>(legend_range(*display_.field, seen_))
                         : std::nullopt;
  }
  emit frameChanged();
}

std::function<std::shared_ptr<const Frame>(int)> Workspace::frameSource() const {
  if (live_) return [frames = liveFrames_.frames()](int number) { return frames.at(static_cast<size_t>(number)); };
  const auto reader = std::make_shared<std::unique_ptr<ResultReader>>();  // opened on the thread that reads
  return [reader, folder = resultsFolder_](int number) {
    if (!*reader) *reader = std::make_unique<ResultReader>(folder);
    return std::make_shared<const Frame>((*reader)->frame(number));
  };
}

void Workspace::setDisplay(const SceneSettings& display) {
  const bool anotherField = display.field != display_.field;
  display_ = display;
  if (anotherField) {
    seen_ = {};
    display_.range.reset();
    if (frame_) takeFrame(frame_);
  }
  emit displayChanged();
}

void Workspace::setRangeFollowsRun(bool follows) {
  rangeFollowsRun_ = follows;
  if (frame_) takeFrame(frame_);
  emit displayChanged();
}

void Workspace::setDark(bool dark) {
  theme::install(dark);
  display_.theme = dark ? Theme::dark : Theme::light;
  emit themeChanged();
  emit displayChanged();
}

void Workspace::setExporting(bool exporting) {
  exporting_ = exporting;
  emit framesChanged();
}

void Workspace::addProblem(const Problem& problem) {
  problems_.push_back(problem);
  log(QStringLiteral("%1: %2; %3").arg(problem.place, problem.problem, problem.remedy));
  emit problemAdded(problem);
  emit problemsChanged();
}

}  // namespace talus
