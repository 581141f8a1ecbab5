#include "widgets/run/cost_ahead.hpp"

#include <QLabel>
#include <QVBoxLayout>

#include "jobs/solver_job.hpp"
#include "render/charts/log_axis.hpp"
#include "session/current_project.hpp"
#include "session/current_run.hpp"
#include "study/accuracy/study_record.hpp"
#include "widgets/kit/numbers.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/text.hpp"

namespace talus {

namespace {

/// A number stays with its unit.
QString inOneLine(QString words) { return words.replace(u' ', QChar::Nbsp); }

QString memoryWords(double bytes) {
  constexpr double megabyte = 1e6, gigabyte = 1e9;
  if (bytes < megabyte) return QObject::tr("less than 1 MB");
  return bytes < gigabyte ? QObject::tr("%1 MB").arg(numbers::whole(std::lround(bytes / megabyte)))
                          : QObject::tr("%1 GB").arg(numbers::figure(bytes / gigabyte, 2));
}

/// With the range, where not all of it was measured.
QString secondsWords(const Forecast& forecast) {
  const auto words = [](double seconds) { return inOneLine(numbers::duration(seconds)); };
  if (forecast.share_seen >= 1) return words(forecast.seconds);
  return QObject::tr("%1 (%2 to %3)").arg(words(forecast.seconds), words(forecast.fewest), words(forecast.most));
}

}  // namespace

CostAhead::CostAhead(CurrentProject& project, CurrentRun& run)
    : project_(project), run_(run), words_(makeWrappedLabel({}, "strong")) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 0);
  words_->setObjectName(QStringLiteral("cost-ahead"));
  column->addWidget(words_);
  connect(&run_, &CurrentRun::effectsChanged, this, &CostAhead::refresh);
  connect(&project_, &CurrentProject::studyChanged, this, &CostAhead::tell);
  connect(&run_, &CurrentRun::reportChanged, this, &CostAhead::refresh);
  connect(&run_.job(), &SolverJob::stateChanged, this, &CostAhead::refresh);
  connect(&job_, &ForecastJob::arrived, this, [this](const Forecast& forecast) {
    forecast_ = forecast;
    tell();
  });
  connect(&job_, &ForecastJob::failed, this, [this](const QString& why) {
    failure_ = why;
    tell();
  });
  refresh();
}

void CostAhead::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  project_.lookForStudy();
  refresh();
}

void CostAhead::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (!job_.isBusy()) return;
  job_.cancel();
  system_.reset();  // nothing is known: it begins anew when it is seen again
}

void CostAhead::refresh() {
  setVisible(project_.document().isOpen() && !run_.job().isBusy());
  if (!isVisible()) return;
  estimate();
  tell();
}

void CostAhead::estimate() {
  if (run_.isDone() && job_.isBusy()) {  // begun as soon as the run had ended, before it was known how
    job_.cancel();
    system_.reset();
  }
  const Project& project = project_.document().project();
  const bool can = run_.whyNotSolve().isEmpty() && project_.systemIsCurrent() && !run_.isDone();
  const bool has = system_ && system_ == project_.system() && of_ == project;
  if (has && (can || run_.isDone())) return;
  forecast_.reset();
  failure_.clear();
  system_ = can ? project_.system() : nullptr;
  of_ = project;
  if (can)
    job_.begin(of_, system_);
  else
    job_.cancel();
}

QString CostAhead::error() const {
  const StudyRecord* study = project_.study();
  auto off = study ? error_of(*study, project_.document().project()) : std::nullopt;
  if (!off && forecast_) off = forecast_->error;
  return off ? tr("about %1").arg(inOneLine(text(error_text(*off)))) : tr("not known");
}

void CostAhead::tell() {
  if (run_.isDone()) {
    words_->setText(
        tr("This run took %1, error %2").arg(inOneLine(numbers::duration(run_.report()->wall_seconds)), error()));
  } else if (!failure_.isEmpty()) {
    words_->setText(tr("This run cannot be estimated: %1.").arg(failure_));
  } else if (!system_) {
    const QString whyNot = run_.whyNotSolve();
    words_->setText(whyNot.isEmpty() ? tr("What this run will cost is said here once its blocks are cut and meshed.")
                                     : tr("%1.").arg(whyNot));
  } else if (!forecast_) {
    words_->setText(tr("This run: estimating…"));
  } else if (!forecast_->failure.empty()) {
    words_->setText(tr("This run will not converge; it ends after about %1 of solving: %2")
                        .arg(secondsWords(*forecast_), text(forecast_->failure)));
  } else {
    words_->setText(tr("This run: about %1, %2, error %3")
                        .arg(secondsWords(*forecast_), inOneLine(memoryWords(forecast_->memory)), error()));
  }
  words_->setToolTip(tr(
      "Solving and writing on this machine, foreseen from the first steps of the run and from the whole of it in "
      "outline, with rigid blocks in long steps. The error is that of the project's accuracy study, or else what its "
      "time steps leave out (step doubling)."));
}

}  // namespace talus
