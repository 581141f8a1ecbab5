#include "jobs/forecast_job.hpp"

#include <utility>

#include "base/error.hpp"

namespace talus {

namespace {
constexpr int quiet_ms = 400;  // a pause in typing
constexpr double budget = 4;   // s of the processor
}  // namespace

ForecastJob::ForecastJob(QObject* parent) : QObject(parent), work_(quiet_ms) {}

void ForecastJob::begin(Project project, std::shared_ptr<const BlockSystem> system) {
  const auto look = [project = std::move(project), system = std::move(system)](Progress& progress) {
    Outcome outcome;
    try {
      outcome.forecast = forecast(project, *system, budget, progress);
    } catch (const InputError& error) {
      outcome.problem = error.problem();
    }
    return outcome;
  };
  work_.begin(look, [this](const Outcome& outcome) { take(outcome); });
}

void ForecastJob::take(const Outcome& outcome) {
  if (outcome.problem.empty())
    emit arrived(outcome.forecast);
  else
    emit failed(QString::fromStdString(outcome.problem));
}

}  // namespace talus
