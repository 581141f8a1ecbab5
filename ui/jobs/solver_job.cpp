#include "jobs/solver_job.hpp"

#include "geometry/splinters_found.hpp"

namespace talus {

namespace {

JobEnd::Kind kindOf(RunStatus status) {
  switch (status) {
    case RunStatus::completed:
      return JobEnd::Kind::completed;
    case RunStatus::stopped:
      return JobEnd::Kind::stopped;
    case RunStatus::not_converged:
    case RunStatus::interpenetrating:
      return JobEnd::Kind::brokenOff;
  }
  return JobEnd::Kind::completed;
}

}  // namespace

SolverJob::SolverJob(SolverParts parts, QObject* parent) : QObject(parent), parts_(std::move(parts)) {
  heartbeat_.setInterval(heartbeat_ms);
  connect(&heartbeat_, &QTimer::timeout, this, &SolverJob::deliver);
}

SolverJob::~SolverJob() {
  if (!thread_) return;
  thread_->disconnect(this);
  exchange_->stop();
  thread_->wait();
}

void SolverJob::start(JobTask task) {
  Q_ASSERT(!isBusy());
  exchange_ = std::make_unique<RunExchange>();
  end_ = {};
  solves_ = task.solve;
  timeLeft_ = {};
  spent_ = 0;
  clock_.start();
  const bool meshed = task.system != nullptr;
  thread_.reset(QThread::create([this, task = std::move(task)] { work(task); }));
  connect(thread_.get(), &QThread::finished, this, &SolverJob::finish);
  thread_->start(QThread::LowPriority);
  heartbeat_.start();
  setState(meshed ? JobState::running : JobState::meshing);
}

void SolverJob::work(const JobTask& task) {
  try {
    std::shared_ptr<const BlockSystem> system = task.system;
    if (!system) {
      system = std::make_shared<BlockSystem>(parts_.mesh(task.project, task.folder, *exchange_));
      exchange_->meshed(system);
      if (const auto size = parts_.size(task.project, *system)) exchange_->sized(*size);
    }
    if (!task.solve) {
      end_.kind = JobEnd::Kind::meshed;
      return;
    }
    if (exchange_->cancelled()) throw Cancelled();
    end_.report = parts_.solve(task.project, *system, task.options, *exchange_);
    end_.kind = kindOf(end_.report->status);
    end_.results = task.options.out;
  } catch (const Cancelled&) {
    end_.kind = JobEnd::Kind::cancelled;
  } catch (const SplintersFound& error) {
    end_.kind = JobEnd::Kind::failed;
    end_.failure = error;
    end_.splinters = error.splinters();
  } catch (const InputError& error) {
    end_.kind = JobEnd::Kind::failed;
    end_.failure = error;
  } catch (const std::exception& error) {
    // Not the user's fault, but the window and the project must outlive it.
    end_.kind = JobEnd::Kind::failed;
    end_.failure = InputError("solver", error.what(), "save the project and report this message");
  }
}

void SolverJob::deliver() {
  const JobNews news = exchange_->take();
  if (state_ == JobState::meshing && solves_ && (news.system || news.solving)) {
    timeLeft_ = {};
    spent_ = 0;
    clock_.restart();
    setState(JobState::running);
  }
  if (state_ == JobState::meshing || state_ == JobState::running)
    timeLeft_.update(spent_ + static_cast<double>(clock_.elapsed()) / 1000, news.fraction);
  emit newsArrived(news);
}

void SolverJob::finish() {
  thread_->wait();
  heartbeat_.stop();
  deliver();
  thread_.reset();
  exchange_.reset();
  setState(JobState::idle);
  emit ended(end_);
}

void SolverJob::pause() {
  if (state_ != JobState::running) return;
  exchange_->pause();
  spent_ += static_cast<double>(clock_.elapsed()) / 1000;
  setState(JobState::paused);
}

void SolverJob::resume() {
  if (state_ != JobState::paused) return;
  clock_.restart();
  exchange_->resume();
  setState(JobState::running);
}

void SolverJob::oneStep() {
  if (state_ == JobState::paused) exchange_->allowSteps(1);
}

void SolverJob::stop() {
  if (!isBusy() || state_ == JobState::stopping) return;
  exchange_->stop();
  setState(JobState::stopping);
}

void SolverJob::setState(JobState state) {
  if (state == state_) return;
  state_ = state;
  emit stateChanged();
}

}  // namespace talus
