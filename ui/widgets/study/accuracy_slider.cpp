#include "widgets/study/accuracy_slider.hpp"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "jobs/solver_job.hpp"
#include "render/charts/log_axis.hpp"
#include "session/current_project.hpp"
#include "session/current_run.hpp"
#include "session/project_study.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"
#include "widgets/study/study_start.hpp"

namespace talus {

AccuracySlider::AccuracySlider(CurrentProject& project, CurrentRun& run, ProjectStudy& study)
    : project_(project),
      run_(run),
      study_(study),
      slider_(new QSlider(Qt::Horizontal)),
      figures_(makeLabel({}, "strong")),
      words_(makeWrappedLabel({}, "small")),
      use_(makeButton(tr("Use"))),
      start_(new StudyStart(study, false)) {
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
  column->addWidget(start_);
  slider_->setPageStep(1);
  slider_->setAccessibleName(tr("From the cheapest setting to the most accurate one"));
  slider_->setToolTip(slider_->accessibleName());
  connect(slider_, &QSlider::valueChanged, this, &AccuracySlider::tell);
  connect(use_, &QPushButton::clicked, this, [this] { project_.useSetting(*project_.study(), best_[position()]); });
  connect(&study_, &ProjectStudy::changed, this, &AccuracySlider::offerStudy);
  connect(&project_, &CurrentProject::studyChanged, this, &AccuracySlider::refresh);
  connect(&project_, &CurrentProject::opened, this, &AccuracySlider::refresh);
  connect(&project_.document(), &Document::projectChanged, this, &AccuracySlider::refresh);
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
  words_->setVisible(!best_.empty());
  offerStudy();
  if (best_.empty()) return;
  const AccuracyRow& chosen = row(best_[position()]);
  const bool own = best_[position()] == has_;
  figures_->setText(
      tr("%1, error %2").arg(numbers::duration(chosen.run->cpu_seconds), text(error_text(*chosen.error))));
  words_->setText(text(chosen.label) + (own ? tr(": as the project is now") : QString()));
  use_->setEnabled(!own);
}

void AccuracySlider::offerStudy() { start_->setVisible(best_.empty() || study_.isBusy()); }

}  // namespace talus
