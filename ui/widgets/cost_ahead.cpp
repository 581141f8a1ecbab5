#include "widgets/cost_ahead.hpp"

#include <QVBoxLayout>

#include "render/log_axis.hpp"
#include "widgets/numbers.hpp"
#include "widgets/parts.hpp"

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

CostAhead::CostAhead(Workspace& workspace) : workspace_(workspace), words_(makeLabel({}, "strong")) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 0);
  words_->setWordWrap(true);
  words_->setObjectName(QStringLiteral("cost-ahead"));
  column->addWidget(words_);
  connect(&workspace_, &Workspace::effectsChanged, this, &CostAhead::refresh);
  connect(&workspace_, &Workspace::studyChanged, this, &CostAhead::tell);
  connect(&workspace_.job(), &SolverJob::stateChanged, this, &CostAhead::refresh);
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
  workspace_.lookForStudy();
  refresh();
}

void CostAhead::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (!job_.isBusy()) return;
  job_.cancel();
  system_.reset();  // nothing is known: it begins anew when it is seen again
}

void CostAhead::refresh() {
  setVisible(workspace_.document().isOpen() && !workspace_.job().isBusy());
  if (!isVisible()) return;
  estimate();
  tell();
}

void CostAhead::estimate() {
  const Project& project = workspace_.document().project();
  const bool can = workspace_.whyNotSolve().isEmpty() && workspace_.systemIsCurrent();
  if (can && system_ == workspace_.system() && of_ == project) return;
  forecast_.reset();
  failure_.clear();
  system_ = can ? workspace_.system() : nullptr;
  of_ = project;
  if (can)
    job_.begin(of_, system_);
  else
    job_.cancel();
}

std::optional<double> CostAhead::error() const {
  const auto& study = workspace_.study();
  const auto studied = study ? error_of(*study, workspace_.document().project()) : std::nullopt;
  return studied ? studied : forecast_ ? forecast_->error : std::nullopt;
}

void CostAhead::tell() {
  if (!failure_.isEmpty()) {
    words_->setText(tr("This run cannot be estimated: %1.").arg(failure_));
  } else if (!system_) {
    const QString whyNot = workspace_.whyNotSolve();
    words_->setText(whyNot.isEmpty() ? tr("What this run will cost is said here once its blocks are cut and meshed.")
                                     : tr("%1.").arg(whyNot));
  } else if (!forecast_) {
    words_->setText(tr("This run: estimating…"));
  } else if (!forecast_->failure.empty()) {
    words_->setText(tr("This run will not converge; it ends after about %1 of solving: %2")
                        .arg(secondsWords(*forecast_), QString::fromStdString(forecast_->failure)));
  } else {
    const auto off = error();
    words_->setText(
        tr("This run: about %1, %2, error %3")
            .arg(secondsWords(*forecast_), inOneLine(memoryWords(forecast_->memory)),
                 off ? tr("about %1").arg(inOneLine(QString::fromStdString(error_text(*off)))) : tr("not known")));
  }
  words_->setToolTip(tr(
      "Solving and writing on this machine, foreseen from the first steps of the run and from the whole of it in "
      "outline, with rigid blocks in long steps. The error is that of the project's accuracy study, or else what its "
      "time steps leave out (step doubling)."));
}

}  // namespace talus
