#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QThread>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "jobs/run_exchange.hpp"
#include "jobs/solver_parts.hpp"
#include "jobs/time_left.hpp"
#include "mesh/cutting_report.hpp"

namespace talus {

/// What a job is to do, by value: the project may be edited while it works.
struct JobTask {
  Project project;
  std::filesystem::path folder;  ///< paths in the project are relative to it
  RunOptions options;
  std::shared_ptr<const BlockSystem> system;  ///< meshed already; empty: mesh first
  bool solve = true;                          ///< false: mesh only
};

enum class JobState { idle, meshing, running, paused, stopping };

/// How a job ended.
struct JobEnd {
  enum class Kind { meshed, completed, stopped, brokenOff, cancelled, failed };
  Kind kind = Kind::completed;
  std::optional<InputError> failure;  ///< why it failed
  std::vector<Splinter> splinters;    ///< for which it failed; empty: for something else
  std::optional<RunReport> report;
  std::filesystem::path results;  ///< empty when nothing was solved
};

/// Meshes and solves on a thread of its own. News come at most ten times a second, by signals on the thread that the
/// job lives on.
class SolverJob : public QObject {
  Q_OBJECT
 public:
  explicit SolverJob(SolverParts parts, QObject* parent = nullptr);
  /// Stops the work and waits for the step that is being made.
  ~SolverJob() override;

  JobState state() const { return state_; }
  bool isBusy() const { return state_ != JobState::idle; }
  /// Of the work that goes on; pauses are not counted.
  const TimeLeft& timeLeft() const { return timeLeft_; }

  /// A busy job must end first.
  void start(JobTask task);
  /// Before the next step.
  void pause();
  void resume();
  /// Makes one step of a paused run.
  void oneStep();
  /// Cancels meshing; ends a run cleanly after its step, its results stay.
  void stop();

 signals:
  void stateChanged();
  void newsArrived(const talus::JobNews& news);
  void ended(const talus::JobEnd& end);

 private:
  void work(const JobTask& task);
  void deliver();
  void finish();
  void setState(JobState state);

  SolverParts parts_;
  JobState state_ = JobState::idle;
  bool solves_ = true;  ///< the task goes on after meshing
  std::unique_ptr<QThread> thread_;
  std::unique_ptr<RunExchange> exchange_;
  QTimer heartbeat_;
  QElapsedTimer clock_;
  double spent_ = 0;  ///< s of the work that goes on, until `clock_` was last started
  TimeLeft timeLeft_;
  JobEnd end_;  ///< written by the worker, read after its thread has ended
};

}  // namespace talus
