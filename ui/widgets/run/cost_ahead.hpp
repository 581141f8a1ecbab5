#pragma once

#include <QWidget>

#include "jobs/forecast_job.hpp"

class QLabel;

namespace talus {

class CurrentProject;
class CurrentRun;

/// Before a run: how long it will take, the memory that it needs and how far off its answer will be. Estimated while it
/// can be seen, of the project as it is; gone while a run goes on. Once the project has been run it says what that
/// took.
class CostAhead : public QWidget {
  Q_OBJECT
 public:
  CostAhead(CurrentProject& project, CurrentRun& run);
  const ForecastJob& job() const { return job_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void refresh();
  void estimate();
  void tell();
  /// In words; of the study where it has this project's setting, else of the forecast.
  QString error() const;

  CurrentProject& project_;
  CurrentRun& run_;
  QLabel* words_;
  std::optional<Forecast> forecast_;
  QString failure_;
  Project of_;  ///< what the forecast is of, or is being made of, with `system_`
  std::shared_ptr<const BlockSystem> system_;
  ForecastJob job_;
};

}  // namespace talus
