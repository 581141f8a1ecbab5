#pragma once

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QTest>
#include <QTimer>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "jobs/solver_job.hpp"
#include "results/frame.hpp"
#include "widgets/view/viewport.hpp"
#include "widgets/window/main_window.hpp"

namespace talus {

/// Notes how long events have to wait: a timer that should fire every 5 ms says how late it came. The time that other
/// programs had the processor is not counted: a busy machine is not the window's doing. That the threads which draw in
/// software were kept from it cannot be told from here, so a single late beat says little; what the window's own thread
/// has worked between two beats says all.
class Watchdog : public QObject {
 public:
  Watchdog();
  void restart();
  double longestWait() const { return longest_; }       ///< ms
  double longestWork() const { return longest_work_; }  ///< ms of the processor between two beats
  double shareLate() const { return beats_ > 0 ? static_cast<double>(late_) / beats_ : 1; }  ///< later than 100 ms
  int beats() const { return beats_; }
  /// No event waits noticeably: none for a tenth of a second of the window's own work, hardly any for that long at all.
  bool isCalm() const { return longestWork() < 100 && shareLate() < 0.01; }

 private:
  QTimer timer_;
  QElapsedTimer since_;
  double longest_ = 0, waited_ = 0, longest_work_ = 0, worked_ = 0;  // ms
  int beats_ = 0, late_ = 0;
};

/// The longest that the window's own thread works between two beats while `action()` goes on, ms: of up to three tries
/// the calmest one, or the first in which it is far below the tenth of a second that a user notices.
template <class Action>
double calmestWork(Action action) {
  constexpr double surely_unnoticed = 60;
  Watchdog watchdog;
  double calmest = std::numeric_limits<double>::infinity();
  for (int tries = 0; tries < 3 && calmest > surely_unnoticed && !::testing::Test::HasFatalFailure(); ++tries) {
    watchdog.restart();
    action();
    calmest = std::min(calmest, watchdog.longestWork());
  }
  return calmest;
}

/// Watches the window while `action(watchdog)` goes on, and expects that it stays calm. What the window itself makes
/// its events wait for it does every time, what the machine does passes: the calmest of three tries counts.
template <class Action>
void expectNoWait(Action action) {
  Watchdog watchdog;
  for (int tries = 0; tries < 3; ++tries) {
    watchdog.restart();
    action(watchdog);
    if (watchdog.isCalm() || ::testing::Test::HasFatalFailure()) break;
  }
  EXPECT_TRUE(watchdog.isCalm()) << "longest work " << watchdog.longestWork() << " ms, longest wait "
                                 << watchdog.longestWait() << " ms, late " << watchdog.shareLate() << " of "
                                 << watchdog.beats() << " beats";
  std::printf("longest work %.1f ms, longest wait %.1f ms, %d beats\n", watchdog.longestWork(), watchdog.longestWait(),
              watchdog.beats());
}

/// A window of 1280 × 800 on a folder of its own.
class DrivenWindow : public ::testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// A window as after a start; one that is there goes.
  void openWindow();
  /// The view gets ready to draw, as it does before a user; in the window of most tests nothing would be drawn by it.
  void warmUp();
  /// Copies samples/NAME into the folder and returns its project file.
  std::filesystem::path sample(const std::string& name);
  /// Two blocks, one fixed: a cube slides down a slope for `steps` steps.
  std::filesystem::path slidingCube(int steps = 4000);
  /// Writes a file into the folder.
  std::filesystem::path write(const std::string& name, const std::string& text);

  /// Works off events until the condition holds, which is looked at after each of them; asleep in between, so that what
  /// is waited for has the processor. False when it does not hold within the limit.
  template <class Condition>
  bool wait(Condition condition, int limit_ms = 60000) {
    QElapsedTimer timer;
    timer.start();
    QTimer tick;  // what is waited for may come without an event
    tick.start(10);
    while (!condition() && timer.elapsed() < limit_ms) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    return condition();
  }
  /// Works off events for a while.
  void rest(int ms);
  /// Drops a file on the window.
  void drop(const std::filesystem::path& file);
  /// Pulls with the left button from one point of a widget to another.
  void drag(QWidget& widget, QPointF from, QPointF to, Qt::KeyboardModifiers keys = {});
  /// Opens a project and waits for its blocks.
  void openAndMesh(const std::filesystem::path& file);
  /// A point of the view where a block lies.
  QPointF pointOnBlock();

  std::filesystem::path folder;
  std::unique_ptr<MainWindow> window;
  Session* session = nullptr;
};

}  // namespace talus
