// A run goes on without the window that it was begun in.
#include <QProcess>
#include <QProgressBar>
#include <QPushButton>
#include <QTest>
#include <fstream>
#include <iterator>

#include "answers.hpp"
#include "driven_window.hpp"
#include "io/whole_file.hpp"
#include "session/current_run.hpp"
#include "widgets/window/window_actions.hpp"

namespace talus {
namespace {

#ifdef TALUS_CLI
class LeftRun : public DrivenWindow {
 protected:
  void SetUp() override {
    qputenv("TALUS_CLI", TALUS_CLI);
    DrivenWindow::SetUp();
  }
  void TearDown() override {
    if (const auto writer = writer_of(results())) QProcess::execute("kill", {QString::number(writer->process)});
    DrivenWindow::TearDown();
    qunsetenv("TALUS_CLI");
  }
  std::filesystem::path results() const { return folder / "cube.results"; }

  /// A run of the project, left by the question that the closing window asks.
  void leave(const std::filesystem::path& file) {
    openAndMesh(file);
    session->solve();
    ASSERT_TRUE(wait([&] { return session->run.steps().size() > 5; }));
    const Answer answer(QStringLiteral("Go on in the background"));
    window->close();
    ASSERT_TRUE(wait([&] { return !window->isVisible(); }));
    ASSERT_FALSE(answer.asked().isEmpty());
    EXPECT_FALSE(session->run.job().isBusy());
    window.reset();
  }
  /// As on another day.
  void openAgain(const std::filesystem::path& file) {
    openWindow();
    window->open(file);
    session->display.goTo(WorkflowPage::solve);
  }
  QAction& stop() { return *window->findChild<WindowActions*>()->stop; }
};

TEST_F(LeftRun, IsSeenAndStoppedByTheNextWindow) {
  const auto file = slidingCube(40000);
  leave(file);
  openAgain(file);
  ASSERT_TRUE(wait([&] { return session->run.outside().isOn(); }));
  const double time = session->run.outside().time();
  ASSERT_TRUE(wait([&] { return session->run.outside().time() > time; })) << "it gets on";
  EXPECT_GT(session->run.fraction(), 0);
  session->display.goTo(WorkflowPage::solve);
  EXPECT_TRUE(session->run.whyNotSolve().contains(QStringLiteral("in the background")));
  EXPECT_TRUE(window->findChild<QPushButton*>("goOn")->isHidden());
  const std::size_t frames = session->playback.times().size();
  ASSERT_TRUE(wait([&] { return session->playback.times().size() > frames; })) << "its frames are seen";
  EXPECT_EQ(session->display.page(), WorkflowPage::solve) << "no page is left for that";
  if (qEnvironmentVariableIsSet("TALUS_KEEP_PICTURES")) window->grab().save(QStringLiteral("left_run.png"));

  ASSERT_TRUE(stop().isEnabled());
  stop().trigger();
  ASSERT_TRUE(wait([&] { return !session->run.outside().isOn() && session->run.report(); }));
  EXPECT_EQ(session->run.report()->status, RunStatus::stopped);
  EXPECT_FALSE(stop().isEnabled());
  ASSERT_TRUE(wait([&] { return session->run.checkpoint() && session->playback.frame(); }));
  EXPECT_TRUE(session->run.whyNotSolve().isEmpty());
  EXPECT_TRUE(session->messages.problems().empty());
}

TEST_F(LeftRun, ComesToTheNumbersOfOneThatNobodyLeft) {
  const auto file = slidingCube(1500);
  leave(file);
  ASSERT_TRUE(wait([&] { return std::filesystem::exists(results() / "summary.json") && !writer_of(results()); }));
  ASSERT_EQ(QProcess::execute(TALUS_CLI, {"solve", QString::fromStdString(file.string()), "--quiet", "--out",
                                          QString::fromStdString((folder / "whole.results").string())}),
            0);
  EXPECT_EQ(read_whole_file(results() / "history.csv"), read_whole_file(folder / "whole.results/history.csv"));
  openAgain(file);
  ASSERT_TRUE(wait([&] { return session->run.report().has_value(); }));
  EXPECT_EQ(session->run.report()->status, RunStatus::completed);
  EXPECT_EQ(session->run.report()->steps, 1500);
}

TEST_F(LeftRun, WithoutTheProgramStopsAndSaysSo) {
  qputenv("TALUS_CLI", "/nowhere/talus-cli");
  openAndMesh(slidingCube(40000));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->run.steps().size() > 5; }));
  const Answer answer(QStringLiteral("Go on in the background"));
  window->close();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
  rest(100);
  EXPECT_TRUE(window->isVisible());
  ASSERT_EQ(session->messages.problems().size(), 1u);
  EXPECT_TRUE(session->messages.problems()[0].place.contains(QStringLiteral("talus-cli")));
  EXPECT_TRUE(session->run.checkpoint());
}
#endif

}  // namespace
}  // namespace talus
