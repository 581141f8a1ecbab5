// Before something is lost the window asks.
#include <QAction>
#include <fstream>

#include "answers.hpp"
#include "driven_window.hpp"
#include "io/project_file.hpp"

namespace talus {
namespace {

class Guarded : public DrivenWindow {
 protected:
  /// Opens a project and changes it.
  std::filesystem::path edited() {
    const auto file = slidingCube(20);
    window->open(file);
    change(25);
    return file;
  }
  void change(double friction) {
    Project project = session->project.document().project();
    project.joints[0].friction_angle = friction;
    session->project.document().change(project, QStringLiteral("change joint J1"));
  }
  double saved(const std::filesystem::path& file) { return read_project(file).joints[0].friction_angle; }
  void trigger(const char* name) {
    for (auto* action : window->actions())
      if (action->text() == QString::fromUtf8(name) && action->isEnabled()) return action->trigger();
    FAIL() << name << " cannot be done";
  }
  bool solved() {
    return wait([&] { return !session->run.job().isBusy() && session->playback.frame(); });
  }
};

TEST_F(Guarded, CloseCancelsSavesOrDiscards) {
  const auto file = edited();
  {
    const Answer answer(QStringLiteral("Cancel"));
    window->close();
    EXPECT_TRUE(answer.asked().contains(QStringLiteral("Sliding cube"))) << answer.asked().toStdString();
    EXPECT_TRUE(window->isVisible());
  }
  const Answer answer(QStringLiteral("Save"));
  window->close();
  EXPECT_FALSE(window->isVisible());
  EXPECT_EQ(saved(file), 25);
}

TEST_F(Guarded, CloseDiscards) {
  const auto file = edited();
  const Answer answer(QStringLiteral("Discard"));
  window->close();
  EXPECT_FALSE(window->isVisible());
  EXPECT_EQ(saved(file), 10);
}

TEST_F(Guarded, NothingIsAskedWhereNothingIsLost) {
  window->open(slidingCube(20));
  const Answer answer(QStringLiteral("Cancel"));
  window->close();
  EXPECT_FALSE(window->isVisible());
  EXPECT_EQ(answer.asked(), QString());
}

TEST_F(Guarded, OpenNewAndDropAskBeforeTheyReplaceTheProject) {
  edited();
  const auto other = sample("free_fall");
  for (const auto& replace :
       {std::function<void()>([&] { window->open(other); }), std::function<void()>([&] { window->newProject(); }),
        std::function<void()>([&] { window->takeDropped(other); }),
        std::function<void()>([&] { window->openCopy(other); })}) {
    const Answer answer(QStringLiteral("Cancel"));
    replace();
    EXPECT_FALSE(answer.asked().isEmpty());
    EXPECT_EQ(session->project.document().name(), QStringLiteral("Sliding cube"));
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
  }
  const Answer answer(QStringLiteral("Discard"));
  window->open(other);
  EXPECT_EQ(session->project.document().file(), other);
}

TEST_F(Guarded, ResultsAreReplacedOnlyWhenAskedFor) {
  window->open(slidingCube(20));
  {
    const Answer answer(QStringLiteral("Cancel"));
    trigger("Solve");
    ASSERT_TRUE(solved());
    EXPECT_EQ(answer.asked(), QString()) << "there are none yet";
  }
  const auto results = folder / "cube.results", kept = folder / "cube-1.results";
  const auto written = std::filesystem::last_write_time(results / "results.h5");
  {
    const Answer answer(QStringLiteral("Cancel"));
    trigger("Solve");
    EXPECT_TRUE(answer.asked().contains(QStringLiteral("cube.results"))) << answer.asked().toStdString();
    EXPECT_FALSE(session->run.job().isBusy());
  }
  {
    const Answer answer(QStringLiteral("Keep as cube-1.results"));
    trigger("Solve");
    ASSERT_TRUE(solved());
  }
  EXPECT_EQ(std::filesystem::last_write_time(kept / "results.h5"), written);
  EXPECT_TRUE(std::filesystem::exists(results / "results.h5"));
  const Answer answer(QStringLiteral("Replace"));
  trigger("Solve");
  ASSERT_TRUE(solved());
  EXPECT_FALSE(std::filesystem::exists(folder / "cube-2.results"));
}

TEST_F(Guarded, ClosingWhileARunGoesOnStopsItOrStays) {
  openAndMesh(slidingCube());
  session->solve();
  ASSERT_TRUE(wait([&] { return session->run.steps().size() > 5; }));
  {
    const Answer answer(QStringLiteral("Stay"));
    window->close();
    EXPECT_TRUE(answer.asked().contains(QStringLiteral("%"))) << answer.asked().toStdString();
    EXPECT_TRUE(window->isVisible());
    EXPECT_TRUE(session->run.job().isBusy());
  }
  const Answer answer(QStringLiteral("Stop and close"));
  window->close();
  EXPECT_TRUE(window->isVisible()) << "until the step has ended";
  ASSERT_TRUE(wait([&] { return !window->isVisible(); }));
  EXPECT_FALSE(session->run.job().isBusy());
}

}  // namespace
}  // namespace talus
