#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "jobs/latest_job.hpp"
#include "study/forecast/forecast.hpp"

namespace talus {

/// Says what a run will cost, from some of its steps, on a thread of its own. What is asked for last counts: an
/// estimate that goes on for something else is dropped, and begins anew after a short quiet time.
class ForecastJob : public QObject {
  Q_OBJECT
 public:
  explicit ForecastJob(QObject* parent = nullptr);

  /// Waits for its turn, or is being made.
  bool isBusy() const { return work_.isBusy(); }
  void begin(Project project, std::shared_ptr<const BlockSystem> system);
  /// What goes on comes to no result.
  void cancel() { work_.cancel(); }

 signals:
  void arrived(const talus::Forecast& forecast);
  /// The project cannot be run as it is; `why` in a few words.
  void failed(const QString& why);

 private:
  struct Outcome {
    Forecast forecast;
    std::string problem;  ///< empty: there is a forecast
  };
  void take(const Outcome& outcome);

  LatestJob work_;
};

}  // namespace talus
