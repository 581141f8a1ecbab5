#pragma once

#include <QTimer>
#include <functional>

#include "jobs/background_job.hpp"

namespace talus {

/// Work of which only what was asked for last counts: it begins after a short quiet time, and what goes on for
/// something else is cancelled and its result dropped. Signals and results come on the thread that the job lives on.
class LatestJob : public QObject {
  Q_OBJECT
 public:
  explicit LatestJob(int quiet_ms, QObject* parent = nullptr);

  /// Waits for its turn, or goes on.
  bool isBusy() const { return wanted_ || work_.isBusy(); }
  /// `work(progress)` runs on a thread of its own and may throw Cancelled; what it returns comes to `take`.
  template <class Work, class Take>
  void begin(Work work, Take take) {
    cancel();
    wanted_ = [this, work = std::move(work), take = std::move(take)] {
      using Result = std::invoke_result_t<Work, Progress&>;
      work_.start<Result>([work](Progress& progress, const auto& ended) { ended(work(progress)); },
                          [this, take](const Result& result) {
                            hasCome_ = true;
                            if (!dropped_) take(result);
                          });
    };
    quiet_.start();
  }
  /// What goes on comes to no result.
  void cancel();

 signals:
  /// Of what goes on: at most ten times a second, 0…1 of it; not any more once its result has been taken.
  void progressed(double fraction, const QString& what);
  /// Nothing is wanted any more, and nothing goes on.
  void rested();

 private:
  void startWanted();

  QTimer quiet_;
  std::function<void()> wanted_;
  bool dropped_ = false;  ///< what goes on is not wanted any more
  bool hasCome_ = false;  ///< its result has; only its thread ends yet
  BackgroundJob work_;    ///< last: its thread ends before the others go
};

}  // namespace talus
