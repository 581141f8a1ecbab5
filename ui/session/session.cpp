#include "session/session.hpp"

#include "base/error.hpp"
#include "io/project_file.hpp"
#include "jobs/solver_job.hpp"

namespace talus {

namespace {

QString text(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

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
      surfaces(project),
      playback(project.document(), messages),
      run(project, playback, messages, std::move(parts)),
      slide(playback),
      histories(project, playback),
      compared(playback, messages),
      study(project, run, messages),
      display(project, playback),
      trails(project, playback, display),
      slips(playback, display),
      line(project, playback, display, picking),
      survey(project),
      colouring(project, survey, display),
      joints(project, surfaces),
      splinters(project, run) {
  QObject::connect(&playback, &Playback::resultsOpened, &display, [this](const ResultsIndex&, bool afterRun) {
    if (!afterRun || (display.page() == WorkflowPage::solve && !run.outside().isOn()))
      display.goTo(WorkflowPage::results);
  });
}

bool Session::isFree(const QString& what) {
  if (!run.isBusy()) return true;
  messages.add({Problem::Severity::warning, what, QObject::tr("a run goes on"),
                QObject::tr("stop it before opening another file")});
  return false;
}

bool Session::open(const std::filesystem::path& path) {
  if (!isFree(text(path))) return false;
  std::error_code unreadable;  // is said by whoever opens it
  return std::filesystem::is_directory(path, unreadable) ? openResults(path) : openProject(path);
}

QString Session::whyNotMesh() const {
  const QString busy = run.whyNotMesh();
  if (!busy.isEmpty()) return busy;
  const bool isFirst = !project.system() && !surfaces.current() && surfaces.isBusy();
  return isFirst ? QObject::tr("The solids are being read") : QString();
}

bool Session::begin(const Draft& draft, const QString& what) {
  if (!isFree(what)) return false;
  try {
    project.document().begin(draft);
  } catch (const InputError& error) {
    Problem problem = problemOf(error);
    problem.place = what + QStringLiteral(": ") + problem.place;
    messages.add(problem);
    return false;
  }
  beginProject(what.toStdString(), QObject::tr("began %1"));
  display.goTo(WorkflowPage::geometry);
  return true;
}

bool Session::openProject(const std::filesystem::path& file) {
  try {
    project.document().open(file);
  } catch (const InputError& error) {
    messages.add(problemIn(file.filename(), error));
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
  Project found;
  try {
    found = read_project(folder / "project.talus");
  } catch (const InputError& error) {
    Problem problem = problemIn(folder, error);
    problem.remedy = QObject::tr("open a project file, or a folder that a run has written");
    messages.add(problem);
    return false;
  }
  opening_ = true;
  incoming_.disconnect();
  QObject::connect(&incoming_, &ResultsLoader::opened, &display,
                   [this, folder, found = std::move(found)] { showResults(folder, found); });
  QObject::connect(&incoming_, &ResultsLoader::failed, &display, [this](const InputError& error) {
    opening_ = false;
    messages.add(problemOf(error, Problem::Of::file));
  });
  incoming_.open(folder);
  return true;
}

void Session::showResults(const std::filesystem::path& folder, const Project& found) {
  opening_ = false;
  incoming_.close();
  if (run.job().isBusy()) return;  // begun meanwhile: it must not lose its project
  // Results lie beside their project, and so do the files that it names.
  project.document().show(found, std::filesystem::absolute(folder).parent_path());
  beginProject(folder, QObject::tr("opened results in %1"));
  playback.open(folder);
}

void Session::beginProject(const std::filesystem::path& path, const QString& sentence) {
  opening_ = false;
  incoming_.disconnect();
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
