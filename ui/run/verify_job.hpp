#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QThread>
#include <QTimer>
#include <memory>
#include <vector>

#include "run/run_exchange.hpp"
#include "run/time_left.hpp"
#include "study/verify.hpp"

namespace talus {

/// Runs cases with a known answer on a thread of its own. Signals come on the thread that the job lives on.
class VerifyJob : public QObject {
  Q_OBJECT
 public:
  explicit VerifyJob(QObject* parent = nullptr);
  /// Cancels and waits for the step that is being made.
  ~VerifyJob() override;

  bool isBusy() const { return thread_ != nullptr; }
  const TimeLeft& timeLeft() const { return timeLeft_; }

  /// One list of cases at a time.
  void start(std::vector<KnownCase> cases, const VerifyOptions& options);
  /// The case that goes on comes to no result; those before keep theirs.
  void cancel();

 signals:
  /// At most ten times a second; 0…1 of all cases.
  void progressed(double fraction, const QString& what);
  void caseEnded(const talus::CaseResult& result);
  /// After the last `caseEnded`, also when it was cancelled.
  void ended();

 private:
  void work(const std::vector<KnownCase>& cases, const VerifyOptions& options);
  void finish();

  std::unique_ptr<QThread> thread_;
  std::unique_ptr<RunExchange> exchange_;
  QTimer heartbeat_;
  QElapsedTimer clock_;
  TimeLeft timeLeft_;
};

}  // namespace talus
