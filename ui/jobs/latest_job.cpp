#include "jobs/latest_job.hpp"

#include <utility>

namespace talus {

LatestJob::LatestJob(int quiet_ms, QObject* parent) : QObject(parent) {
  quiet_.setSingleShot(true);
  quiet_.setInterval(quiet_ms);
  connect(&quiet_, &QTimer::timeout, this, &LatestJob::startWanted);
  connect(&work_, &BackgroundJob::progressed, this, [this](double fraction, const QString& what) {
    if (!hasCome_) emit progressed(fraction, what);
  });
  connect(&work_, &BackgroundJob::ended, this, [this] {
    startWanted();
    if (!isBusy()) emit rested();
  });
}

void LatestJob::cancel() {
  quiet_.stop();
  wanted_ = {};
  dropped_ = true;
  work_.cancel();
}

void LatestJob::startWanted() {
  if (!wanted_ || quiet_.isActive() || work_.isBusy()) return;
  dropped_ = hasCome_ = false;
  const auto start = std::exchange(wanted_, {});
  start();
}

}  // namespace talus
