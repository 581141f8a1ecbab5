#include "jobs/forecast_job.hpp"

#include <utility>

#include "base/error.hpp"

namespace talus {

namespace {
constexpr int quiet_ms = 400;  // a pause in typing
constexpr double budget = 4;   // s of the processor
}  // namespace

ForecastJob::ForecastJob(QObject* parent) : QObject(parent) {
  quiet_.setSingleShot(true);
  quiet_.setInterval(quiet_ms);
  connect(&quiet_, &QTimer::timeout, this, &ForecastJob::startWanted);
  connect(&work_, &BackgroundJob::ended, this, &ForecastJob::startWanted);
}

void ForecastJob::begin(Project project, std::shared_ptr<const BlockSystem> system) {
  cancel();
  wanted_ = Task{std::move(project), std::move(system)};
  quiet_.start();
}

void ForecastJob::cancel() {
  quiet_.stop();
  wanted_.reset();
  dropped_ = true;
  work_.cancel();
}

void ForecastJob::startWanted() {
  if (!wanted_ || quiet_.isActive() || work_.isBusy()) return;
  dropped_ = false;
  const auto look = [task = *std::exchange(wanted_, std::nullopt)](Progress& progress, const auto& ended) {
    Outcome outcome;
    try {
      outcome.forecast = forecast(task.project, *task.system, budget, progress);
    } catch (const InputError& error) {
      outcome.problem = error.problem();
    }
    ended(outcome);
  };
  work_.start<Outcome>(look, [this](const Outcome& outcome) { take(outcome); });
}

void ForecastJob::take(const Outcome& outcome) {
  if (dropped_) return;
  if (outcome.problem.empty())
    emit arrived(outcome.forecast);
  else
    emit failed(QString::fromStdString(outcome.problem));
}

}  // namespace talus
