#include "session/project_problems.hpp"

#include <algorithm>

#include "document/document.hpp"
#include "document/item_at.hpp"
#include "geometry/block_builder.hpp"
#include "jobs/background_job.hpp"
#include "model/rules/project_problems.hpp"
#include "model/solid_shape.hpp"

namespace talus {

namespace {

constexpr int soon_ms = 60;

Problem::Severity severityOf(ProjectProblem::Kind kind) {
  switch (kind) {
    case ProjectProblem::Kind::error:
      return Problem::Severity::error;
    case ProjectProblem::Kind::warning:
      return Problem::Severity::warning;
    case ProjectProblem::Kind::hint:
      break;
  }
  return Problem::Severity::info;
}

Problem problemAt(const Project& project, const std::string& place, const std::string& problem,
                  const std::string& remedy, Problem::Severity severity) {
  Problem made = problemOf(InputError(place, problem, remedy), severity);
  made.field = made.place;
  made.place = placeWords(project, made.field);
  return made;
}

bool tellsTheSame(const Problem& a, const Problem& b) {
  return a.severity == b.severity && a.field == b.field && a.problem == b.problem;
}

}  // namespace

ProjectProblems::ProjectProblems(Document& document) : document_(document) {
  soon_.setSingleShot(true);
  soon_.setInterval(soon_ms);
  connect(&soon_, &QTimer::timeout, this, &ProjectProblems::look);
  connect(&document_, &Document::opened, this, &ProjectProblems::look);
  connect(&document_, &Document::projectChanged, &soon_, qOverload<>(&QTimer::start));
}

ProjectProblems::~ProjectProblems() = default;

int ProjectProblems::count(Problem::Severity severity) const {
  return static_cast<int>(
      std::count_if(all_.begin(), all_.end(), [severity](const Problem& one) { return one.severity == severity; }));
}

QString ProjectProblems::whyNotSolve() const {
  const int errors = count(Problem::Severity::error);
  if (errors == 0) return {};
  const QString first = tr("%1: %2").arg(all_.front().place, all_.front().problem);
  return errors == 1 ? first : tr("%1; and %2 more under Problems").arg(first).arg(errors - 1);
}

bool ProjectProblems::isReading() const { return job_ && job_->isBusy(); }

void ProjectProblems::look() {
  soon_.stop();
  std::vector<Problem> found;
  for (const ProjectProblem& one : problems_of(document_.project()))
    found.push_back(problemAt(document_.project(), one.place, one.problem, one.remedy, severityOf(one.kind)));
  lookAtFiles();
  for (const InputError& error : brokenFiles_)
    found.push_back(
        problemAt(document_.project(), error.place(), error.problem(), error.remedy(), Problem::Severity::error));
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.severity > b.severity; });
  if (std::equal(found.begin(), found.end(), all_.begin(), all_.end(), tellsTheSame)) return;
  all_ = std::move(found);
  emit changed();
}

std::vector<ProjectProblems::LookedAt> ProjectProblems::filesNow() const {
  std::vector<LookedAt> files;
  for (const Solid& solid : document_.project().solids) {
    const std::string* path = file_of(solid.shape);
    if (!path) continue;
    const std::filesystem::path file = document_.folder() / *path;
    std::error_code missing;
    files.push_back({file, solid.shape, std::filesystem::last_write_time(file, missing)});
  }
  return files;
}

void ProjectProblems::lookAtFiles() {
  std::vector<LookedAt> files = filesNow();
  if (files == lookedAt_) return;
  lookedAt_ = std::move(files);
  brokenFiles_.clear();
  job_.reset();
  if (lookedAt_.empty()) return;
  job_ = std::make_unique<BackgroundJob>();
  const auto read = [project = document_.project(), folder = document_.folder()](Progress& progress, const auto& tell) {
    try {
      tell(broken_files(project, folder, progress));
    } catch (const std::exception&) {
      // Without its mesher the program says so when the rock is to be cut.
    }
  };
  job_->start<std::vector<InputError>>(read, [this](const std::vector<InputError>& broken) {
    brokenFiles_ = broken;
    look();
  });
}

}  // namespace talus
