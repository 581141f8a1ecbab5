#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QThread>
#include <QTimer>
#include <functional>
#include <memory>

#include "jobs/run_exchange.hpp"
#include "jobs/time_left.hpp"

namespace talus {

/// Work on a thread of its own that brings its results one by one: known answers, hard cases, a study, a forecast.
/// Signals come on the thread that the job lives on.
class BackgroundJob : public QObject {
  Q_OBJECT
 public:
  explicit BackgroundJob(QObject* parent = nullptr);
  /// Cancels and waits for the step that is being made.
  ~BackgroundJob() override;

  bool isBusy() const { return thread_ != nullptr; }
  const TimeLeft& timeLeft() const { return timeLeft_; }

  /// One list at a time. `run(progress, ended)` works on the job's own thread and calls `ended(result)` for each run as
  /// it ends; each result comes to `take` on the thread that the job lives on. May throw Cancelled.
  template <class Result, class Run, class Take>
  void start(Run run, Take take) {
    startWork([this, run = std::move(run), take = std::move(take)](Progress& progress) {
      run(progress, [this, &take](const Result& result) {
        QMetaObject::invokeMethod(
            this, [take, result] { take(result); }, Qt::QueuedConnection);
      });
    });
  }
  /// The run that goes on comes to no result; those before keep theirs.
  void cancel();

 signals:
  /// At most ten times a second; 0…1 of the whole list.
  void progressed(double fraction, const QString& what);
  /// After the last result was taken, also when it was cancelled.
  void ended();

 private:
  void startWork(std::function<void(Progress&)> work);
  void finish();

  std::unique_ptr<QThread> thread_;
  std::unique_ptr<RunExchange> exchange_;
  QTimer heartbeat_;
  QElapsedTimer clock_;
  TimeLeft timeLeft_;
};

}  // namespace talus
