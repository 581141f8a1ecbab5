#include "jobs/background_job.hpp"

#include "base/error.hpp"

namespace talus {

BackgroundJob::BackgroundJob(QObject* parent) : QObject(parent) {
  heartbeat_.setInterval(heartbeat_ms);
  connect(&heartbeat_, &QTimer::timeout, this, [this] {
    const JobNews news = exchange_->take();
    timeLeft_.update(static_cast<double>(clock_.elapsed()) / 1000, news.fraction);
    emit progressed(news.fraction, QString::fromStdString(news.what));
  });
}

BackgroundJob::~BackgroundJob() {
  if (!thread_) return;
  thread_->disconnect(this);
  exchange_->stop();
  thread_->wait();
}

void BackgroundJob::startWork(std::function<void(Progress&)> work) {
  Q_ASSERT(!isBusy());
  exchange_ = std::make_unique<RunExchange>();
  timeLeft_ = {};
  clock_.start();
  thread_.reset(QThread::create([this, work = std::move(work)] {
    try {
      work(*exchange_);
    } catch (const Cancelled&) {
      return;
    }
  }));
  connect(thread_.get(), &QThread::finished, this, &BackgroundJob::finish);
  thread_->start(QThread::LowPriority);
  heartbeat_.start();
}

void BackgroundJob::cancel() {
  if (exchange_) exchange_->stop();
}

void BackgroundJob::finish() {
  thread_->wait();
  heartbeat_.stop();
  thread_.reset();
  exchange_.reset();
  emit ended();
}

}  // namespace talus
