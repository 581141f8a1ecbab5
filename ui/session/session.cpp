#include "session/session.hpp"

#include "base/error.hpp"
#include "io/project_file.hpp"
#include "jobs/solver_job.hpp"

namespace talus {

namespace {

QString text(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

/// Where in the file, and which file.
Problem problemIn(const QString& file, const InputError& error) {
  Problem problem = problemOf(error);
  problem.place = file + QStringLiteral(": ") + problem.place;
  return problem;
}

/// The results in a folder are those of this project. Of an older program's nothing is known: they can still be opened
/// as a folder.
bool belong(const std::filesystem::path& folder, const Project& project) {
  std::error_code ignored;
  if (!std::filesystem::exists(folder / "project.talus", ignored)) return false;
  try {
    return read_project(folder / "project.talus") == project;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

Session::Session(SolverParts parts)
    : project(messages),
      playback(project.document(), messages),
      run(project, playback, messages, std::move(parts)),
      display(project, playback) {
  QObject::connect(&playback, &Playback::resultsOpened, &display, [this](const ResultsIndex&, bool afterRun) {
    if (!afterRun || display.page() == WorkflowPage::solve) display.goTo(WorkflowPage::results);
  });
}

bool Session::open(const std::filesystem::path& path) {
  if (run.job().isBusy()) {
    messages.add({Problem::Severity::warning, text(path), QObject::tr("a run goes on"),
                  QObject::tr("stop it before opening another file")});
    return false;
  }
  std::error_code unreadable;  // is said by whoever opens it
  return std::filesystem::is_directory(path, unreadable) ? openResults(path) : openProject(path);
}

bool Session::openProject(const std::filesystem::path& file) {
  try {
    project.document().open(file);
  } catch (const InputError& error) {
    messages.add(problemIn(text(file.filename()), error));
    return false;
  }
  beginProject(project.document().file(), QObject::tr("opened %1"));
  const auto results = project.document().resultsFolder();
  if (belong(results, project.document().project()))
    playback.open(results);
  else
    display.goTo(WorkflowPage::geometry);
  return true;
}

bool Session::openResults(const std::filesystem::path& folder) {
  try {
    project.document().show(read_project(folder / "project.talus"));
  } catch (const InputError& error) {
    Problem problem = problemIn(text(folder), error);
    problem.remedy = QObject::tr("open a project file, or a folder that a run has written");
    messages.add(problem);
    return false;
  }
  beginProject(folder, QObject::tr("opened results in %1"));
  playback.open(folder);
  return true;
}

void Session::beginProject(const std::filesystem::path& path, const QString& sentence) {
  playback.clear();
  run.clear();
  project.setSystem(nullptr);
  project.beginBuilding();
  messages.clear();
  emit project.opened();
  messages.log(sentence.arg(text(path)));
  project.lookForStudy();
}

void Session::solve() {
  if (!run.whyNotSolve().isEmpty()) return;
  run.solve();
  display.goTo(WorkflowPage::solve);
}

}  // namespace talus
