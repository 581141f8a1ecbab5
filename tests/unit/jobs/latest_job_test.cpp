// Work of which only the last that was asked for counts.
#include "jobs/latest_job.hpp"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QThread>
#include <memory>

namespace talus {
namespace {

/// What a thread takes some time to give up once it has handed over a copy.
struct SlowToGo {
  QThread* watcher = nullptr;
  ~SlowToGo() {
    if (QThread::currentThread() != watcher) QThread::msleep(300);
  }
};

template <class Condition>
bool wait(const Condition& condition) {
  QElapsedTimer timer;
  for (timer.start(); !condition() && timer.elapsed() < 10000;) QCoreApplication::processEvents({}, 20);
  return condition();
}

TEST(LatestJob, SaysNothingOfProgressOnceItsResultHasBeenTaken) {
  int argc = 0;
  std::unique_ptr<QCoreApplication> application;
  if (!QCoreApplication::instance()) application = std::make_unique<QCoreApplication>(argc, nullptr);
  LatestJob job(0);
  QString said;
  bool rested = false;
  QObject::connect(&job, &LatestJob::progressed, [&](double, const QString& what) { said = what; });
  QObject::connect(&job, &LatestJob::rested, [&] { rested = true; });
  job.begin(
      [watcher = QThread::currentThread()](Progress& progress) {
        progress.report(0.5, "reading");
        QThread::msleep(250);
        SlowToGo result;
        result.watcher = watcher;
        return result;
      },
      [&](const SlowToGo&) { said = QStringLiteral("read"); });
  ASSERT_TRUE(wait([&] { return said == QStringLiteral("reading"); }));
  ASSERT_TRUE(wait([&] { return rested; }));
  EXPECT_EQ(said, QStringLiteral("read"));
}

}  // namespace
}  // namespace talus
