#include "driven_window.hpp"

#include <unistd.h>

#include <QApplication>
#include <QDropEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QUrl>
#include <fstream>

namespace talus {

namespace {

/// ms that this thread has run, and that it could have run but other programs had the processor, by the kernel's count;
/// 0 where it keeps none.
struct Share {
  double worked = 0, waited = 0;
};

Share shareOfTheProcessor() {
  std::ifstream counts("/proc/thread-self/schedstat");
  Share share;
  counts >> share.worked >> share.waited;
  return {share.worked * 1e-6, share.waited * 1e-6};
}

}  // namespace

Watchdog::Watchdog() {
  timer_.setInterval(5);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, [this] {
    const auto [worked, waited] = shareOfTheProcessor();
    if (since_.isValid()) {
      const double wait = static_cast<double>(since_.nsecsElapsed()) * 1e-6 - (waited - waited_);
      longest_ = std::max(longest_, wait);
      longest_work_ = std::max(longest_work_, worked - worked_);
      late_ += wait > 100 ? 1 : 0;
    }
    worked_ = worked;
    waited_ = waited;
    since_.restart();
    ++beats_;
  });
  timer_.start();
}

void Watchdog::restart() {
  longest_ = longest_work_ = 0;
  beats_ = late_ = 0;
  const auto [worked, waited] = shareOfTheProcessor();
  worked_ = worked;
  waited_ = waited;
  since_.restart();
}

void DrivenWindow::SetUp() {
  folder = std::filesystem::temp_directory_path() / ("talus_window_" + std::to_string(::getpid()) + "_" +
                                                     ::testing::UnitTest::GetInstance()->current_test_info()->name());
  std::filesystem::create_directories(folder);
  openWindow();
}

void DrivenWindow::openWindow() {
  window = std::make_unique<MainWindow>();
  session = &window->session();
  window->resize(1280, 800);
  window->show();
  rest(50);
}

void DrivenWindow::warmUp() {
  QTimer::singleShot(0, &window->viewport(), &Viewport::warmUp);
  rest(50);
}

void DrivenWindow::TearDown() {
  window.reset();
  std::filesystem::remove_all(folder);
}

std::filesystem::path DrivenWindow::sample(const std::string& name) {
  const std::filesystem::path source = std::filesystem::path(TALUS_SOURCE_DIR) / "samples" / name;
  std::filesystem::copy(source, folder / name, std::filesystem::copy_options::recursive);
  return folder / name / (name + ".talus");
}

std::filesystem::path DrivenWindow::write(const std::string& name, const std::string& text) {
  std::ofstream(folder / name) << text;
  return folder / name;
}

std::filesystem::path DrivenWindow::slidingCube(int steps) {
  return write("cube.talus", R"({
  "talus": 1, "name": "Sliding cube", "gravity": [4.905, 0, -8.496],
  "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.25}},
  "joints": {"J1": {"friction_angle": 10}},
  "default_joint": "J1",
  "solids": [
    {"name": "base", "box": {"min": [0, 0, 0], "max": [40, 4, 1]}, "material": "rock", "body": "fixed", "mesh_size": 2},
    {"name": "cube", "box": {"min": [1, 1, 1], "max": [3, 3, 3]}, "material": "rock", "mesh_size": 1}],
  "stages": [{"name": "slide", "type": "dynamic", "time_step": 0.002, "steps": )" +
                                 std::to_string(steps) + R"(}],
  "monitors": [{"name": "P1", "block": "cube", "at": [2, 2, 3]}],
  "output": {"every": 0.02}
})");
}

void DrivenWindow::rest(int ms) {
  QTest::qWait(ms);
  QCoreApplication::processEvents();  // a watchdog beats between what took longer than that and what comes next
}

void DrivenWindow::drop(const std::filesystem::path& file) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QString::fromStdString(file.string()))});
  QDragEnterEvent enter({400, 300}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(window.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent event({400, 300}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(window.get(), &event);
  rest(30);
}

void DrivenWindow::drag(QWidget& widget, QPointF from, QPointF to, Qt::KeyboardModifiers keys) {
  constexpr int moves = 8;
  const auto send = [&](QEvent::Type type, QPointF at) {
    QMouseEvent event(type, at, widget.mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, keys);
    QApplication::sendEvent(&widget, &event);
  };
  send(QEvent::MouseButtonPress, from);
  for (int i = 1; i <= moves; ++i) send(QEvent::MouseMove, from + (to - from) * i / moves);
  send(QEvent::MouseButtonRelease, to);
  rest(20);
}

void DrivenWindow::openAndMesh(const std::filesystem::path& file) {
  window->open(file);
  ASSERT_TRUE(session->project.document().isOpen());
  session->run.mesh();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
  ASSERT_NE(session->project.system(), nullptr);
  rest(50);
}

QPointF DrivenWindow::pointOnBlock() {
  const Viewport& view = window->viewport();
  for (int y = 20; y < view.height(); y += 20)
    for (int x = 20; x < view.width(); x += 20)
      if (view.pickAt({static_cast<double>(x), static_cast<double>(y)}))
        return {static_cast<double>(x), static_cast<double>(y)};
  return {-1, -1};
}

}  // namespace talus
