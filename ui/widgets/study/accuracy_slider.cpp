#include "widgets/study/accuracy_slider.hpp"

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "jobs/solver_job.hpp"
#include "render/charts/log_axis.hpp"
#include "session/current_project.hpp"
#include "session/current_run.hpp"
#include "session/messages.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

AccuracySlider::AccuracySlider(CurrentProject& project, CurrentRun& run, Messages& messages)
    : project_(project),
      run_(run),
      messages_(messages),
      slider_(new QSlider(Qt::Horizontal)),
      figures_(makeLabel({}, "strong")),
      words_(makeWrappedLabel({}, "small")),
      use_(makeButton(tr("Use"))),
      study_(makeButton({})),
      bar_(makeProgressBar()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 10);
  column->setSpacing(4);
  column->addWidget(makeLabel(tr("Accuracy"), "section"));
  auto* ends = new QHBoxLayout;
  setMargins(ends, 0, 8);
  ends->addWidget(makeLabel(tr("draft"), "small"));
  ends->addWidget(slider_, 1);
  ends->addWidget(makeLabel(tr("reference"), "small"));
  column->addLayout(ends);
  auto* chosen = new QHBoxLayout;
  setMargins(chosen, 0, 8);
  chosen->addWidget(figures_, 1);
  chosen->addWidget(use_);
  column->addLayout(chosen);
  column->addWidget(words_);
  bar_->setAccessibleName(tr("Share of the study that is done"));
  auto* study = new QHBoxLayout;
  study->setContentsMargins(0, 4, 0, 0);
  study->setSpacing(8);
  study->addWidget(study_);
  study->addWidget(bar_, 1);
  study->addStretch();
  column->addLayout(study);
  slider_->setPageStep(1);
  slider_->setAccessibleName(tr("From the cheapest setting to the most accurate one"));
  slider_->setToolTip(slider_->accessibleName());
  connect(slider_, &QSlider::valueChanged, this, &AccuracySlider::tell);
  connect(use_, &QPushButton::clicked, this, [this] { project_.useSetting(*project_.study(), best_[position()]); });
  connect(study_, &QPushButton::clicked, this, &AccuracySlider::startOrStop);
  connect(&job_, &StudyJob::progressed, this, &AccuracySlider::tellHowTheStudyGoes);
  connect(&job_, &StudyJob::ended, this, &AccuracySlider::takeEnd);
  connect(&project_, &CurrentProject::studyChanged, this, &AccuracySlider::refresh);
  connect(&project_, &CurrentProject::opened, &job_, &StudyJob::cancel);
  connect(&project_, &CurrentProject::opened, this, &AccuracySlider::refresh);
  connect(&project_.document(), &Document::projectChanged, this, &AccuracySlider::refresh);
  connect(&project_.document(), &Document::savedChanged, this, &AccuracySlider::tell);
  connect(&run_.job(), &SolverJob::stateChanged, this, &AccuracySlider::refresh);
  refresh();
}

const AccuracyRow& AccuracySlider::row(int run) const {
  return project_.study()->study.rows[static_cast<std::size_t>(run)];
}

void AccuracySlider::refresh() {
  const StudyRecord* study = project_.study();
  setVisible(project_.document().isOpen() && !run_.job().isBusy());
  has_ = study ? run_of(*study, project_.document().project()) : std::nullopt;
  best_ = has_ ? best_by_cost(study->study) : std::vector<int>();
  const QSignalBlocker silent(slider_);
  slider_->setRange(0, std::max(0, static_cast<int>(best_.size()) - 1));
  slider_->setEnabled(best_.size() > 1);
  if (!best_.empty()) {
    // The project's own place, or else the first that costs as much: what it has may not be the best for its cost.
    const double seconds = row(*has_).run ? row(*has_).run->cpu_seconds : 0;
    const auto place = std::find_if(best_.begin(), best_.end(),
                                    [&](int run) { return run == *has_ || row(run).run->cpu_seconds >= seconds; });
    slider_->setValue(static_cast<int>(place - best_.begin()));
  }
  tell();
}

void AccuracySlider::tell() {
  figures_->setVisible(!best_.empty());
  use_->setVisible(!best_.empty());
  study_->setVisible(best_.empty() || job_.isBusy());
  bar_->setVisible(job_.isBusy());
  if (best_.empty()) return tellHowToGetAStudy();
  const AccuracyRow& chosen = row(best_[position()]);
  const bool own = best_[position()] == has_;
  figures_->setText(
      tr("%1, error %2").arg(numbers::duration(chosen.run->cpu_seconds), text(error_text(*chosen.error))));
  words_->setText(text(chosen.label) + (own ? tr(": as the project is now") : QString()));
  use_->setEnabled(!own);
}

void AccuracySlider::tellHowToGetAStudy() {
  if (job_.isBusy()) return;
  const bool outdated = project_.study() && !has_;
  words_->setText(outdated ? tr("The study is of this project before it was changed.")
                           : tr("What accuracy costs is not known yet. A study solves the project under some twenty "
                                "settings, from the cheapest to the finest, and tells error and seconds of each."));
  study_->setText(outdated ? tr("Study again") : tr("Study accuracy"));
  const bool saved = project_.document().isSaved() && !project_.document().file().empty();
  study_->setEnabled(saved);
  study_->setToolTip(saved
                         ? tr("In the background; it takes many times as long as one run. What it has is kept when it "
                              "is stopped")
                         : tr("A study is made of the project's file: save it first"));
}

void AccuracySlider::tellHowTheStudyGoes(double fraction, const QString& what) {
  const auto left = job_.timeLeft().seconds();
  showShare(*bar_, fraction);
  words_->setText(left ? tr("%1; %2 left").arg(what, numbers::duration(*left)) : what);
}

void AccuracySlider::startOrStop() {
  if (job_.isBusy()) {
    study_->setEnabled(false);
    job_.cancel();
    return;
  }
  job_.begin({project_.document().file(), false, {}, TALUS_VERSION});
  study_->setText(tr("Stop"));
  study_->setToolTip(tr("Runs that have ended are kept; the study can go on later"));
  tellHowTheStudyGoes(0, tr("The study begins"));
  tell();
}

void AccuracySlider::takeEnd(const QString& problem) {
  if (!problem.isEmpty())
    messages_.add({Problem::Severity::warning, tr("accuracy study"), problem, tr("what has ended is kept")});
  project_.lookForStudy();
  refresh();
}

}  // namespace talus
