#include "session/project_study.hpp"

#include "jobs/solver_job.hpp"
#include "session/current_project.hpp"
#include "session/current_run.hpp"
#include "session/messages.hpp"

namespace talus {

ProjectStudy::ProjectStudy(CurrentProject& project, CurrentRun& run, Messages& messages)
    : project_(project), run_(run), messages_(messages) {
  connect(&job_, &StudyJob::progressed, this, [this](double fraction, const QString& what) {
    fraction_ = fraction;
    activity_ = what;
    emit changed();
  });
  connect(&job_, &StudyJob::ended, this, &ProjectStudy::takeEnd);
  connect(&project_, &CurrentProject::opened, &job_, &StudyJob::cancel);
  for (const auto signal : {&CurrentProject::opened, &CurrentProject::studyChanged}) {
    connect(&project_, signal, this, &ProjectStudy::changed);
    connect(&project_, signal, this, &ProjectStudy::madeAnother);
  }
  connect(&project_.document(), &Document::projectChanged, this, &ProjectStudy::changed);
  connect(&project_.document(), &Document::savedChanged, this, &ProjectStudy::changed);
  connect(&project_.problems(), &ProjectProblems::changed, this, &ProjectStudy::changed);
  connect(&run_.job(), &SolverJob::stateChanged, this, &ProjectStudy::changed);
}

bool ProjectStudy::isOutdated() const { return project_.study() && !isCurrent(); }

bool ProjectStudy::isCurrent() const {
  return project_.study() && run_of(*project_.study(), project_.document().project());
}

bool ProjectStudy::isComplete() const { return project_.study() && project_.study()->study.complete(); }

StudyWish ProjectStudy::wish() const {
  if (!project_.study()) return {};
  const AccuracyStudy& study = project_.study()->study;
  const bool usual = study.known_answer || study.measure == StudyMeasure::displacement;
  return {usual ? std::nullopt : std::optional(study.measure), study.repeats};
}

QString ProjectStudy::whyNot(const StudyWish& wish) const {
  const Document& document = project_.document();
  if (!document.isOpen()) return tr("Open a project first");
  if (!document.isSaved() || document.file().empty()) return tr("A study is made of the project's file: save it first");
  if (isCurrent() && isComplete() && wish == this->wish()) return tr("The study has all of these runs");
  return run_.whyNotSolve();
}

void ProjectStudy::begin(const StudyWish& wish) {
  if (job_.isBusy() || !whyNot(wish).isEmpty()) return;
  fraction_ = 0;
  activity_ = tr("The study begins");
  job_.begin({project_.document().file(), false, {}, TALUS_VERSION, wish.repeats, wish.measure});
  emit changed();
}

void ProjectStudy::cancel() {
  if (!job_.isBusy()) return;
  stopping_ = true;
  job_.cancel();
  emit changed();
}

void ProjectStudy::takeEnd(const QString& problem) {
  stopping_ = false;
  if (!problem.isEmpty())
    messages_.add({Problem::Severity::warning, tr("accuracy study"), problem, tr("what has ended is kept")});
  project_.lookForStudy();
  emit changed();
}

}  // namespace talus
