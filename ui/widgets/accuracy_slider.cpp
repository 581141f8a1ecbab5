#include "widgets/accuracy_slider.hpp"

#include <QVBoxLayout>
#include <algorithm>

#include "render/log_axis.hpp"
#include "widgets/numbers.hpp"
#include "widgets/parts.hpp"

namespace talus {

AccuracySlider::AccuracySlider(Workspace& workspace)
    : workspace_(workspace),
      slider_(new QSlider(Qt::Horizontal)),
      figures_(makeLabel({}, "strong")),
      words_(makeLabel({}, "small")),
      use_(makeButton(tr("Use"))) {
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
  words_->setWordWrap(true);
  column->addWidget(words_);
  slider_->setPageStep(1);
  slider_->setAccessibleName(tr("From the cheapest setting to the most accurate one"));
  connect(slider_, &QSlider::valueChanged, this, &AccuracySlider::tell);
  connect(use_, &QPushButton::clicked, this, [this] { workspace_.useSetting(*workspace_.study(), best_[position()]); });
  connect(&workspace_, &Workspace::studyChanged, this, &AccuracySlider::refresh);
  connect(&workspace_, &Workspace::projectOpened, this, &AccuracySlider::refresh);
  connect(&workspace_.document(), &Document::projectChanged, this, &AccuracySlider::refresh);
  connect(&workspace_.job(), &SolverJob::stateChanged, this, &AccuracySlider::refresh);
  refresh();
}

const AccuracyRow& AccuracySlider::row(int run) const {
  return workspace_.study()->study.rows[static_cast<std::size_t>(run)];
}

void AccuracySlider::refresh() {
  const auto& study = workspace_.study();
  setVisible(workspace_.document().isOpen() && !workspace_.job().isBusy());
  has_ = study ? run_of(*study, workspace_.document().project()) : std::nullopt;
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
  if (best_.empty()) {
    const QString file = QString::fromStdString(workspace_.document().file().filename().string());
    const QString how = tr("talus-cli study accuracy %1").arg(file.isEmpty() ? tr("PROJECT") : file);
    say({}, workspace_.study() && !has_
                ? tr("The study is of this project before it was changed. Run it again: %1 --restart").arg(how)
                : tr("What accuracy costs is not known yet. Run a study: %1").arg(how));
    use_->setEnabled(false);
    return;
  }
  const AccuracyRow& chosen = row(best_[position()]);
  const bool own = best_[position()] == has_;
  say(tr("%1, error %2")
          .arg(numbers::duration(chosen.run->cpu_seconds), QString::fromStdString(error_text(*chosen.error))),
      QString::fromStdString(chosen.label) + (own ? tr(": as the project is now") : QString()));
  use_->setEnabled(!own);
}

void AccuracySlider::say(const QString& figures, const QString& words) {
  figures_->setText(figures);
  words_->setText(words);
  figures_->setVisible(!figures.isEmpty());
  use_->setVisible(!figures.isEmpty());
}

}  // namespace talus
