#include "widgets/run/cost_ahead.hpp"

#include <QLabel>
#include <QRegularExpression>

#include "listed_runs.hpp"
#include "render/charts/log_axis.hpp"
#include "studied_window.hpp"
#include "widgets/kit/theme.hpp"

namespace talus {
namespace {

class CostAheadTest : public StudiedWindow {
 protected:
  QString said() const {
    return window->findChild<QLabel*>(QStringLiteral("cost-ahead"))->text().replace(QChar::Nbsp, u' ');
  }
  bool waitForTheEstimate() {
    return wait([&] { return said().contains(QStringLiteral("error ")); }, 20000);
  }
};

TEST_F(CostAheadTest, IsSaidOnceThereAreBlocksAndAnewWhenTheProjectChanges) {
  warmUp();
  window->open(slidingCube(20000));  // too long to be measured to its end
  session->display.goTo(WorkflowPage::solve);
  EXPECT_TRUE(said().contains(QStringLiteral("once its blocks are cut")));
  session->run.mesh();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
  EXPECT_EQ(said(), QStringLiteral("This run: estimating…"));
  rest(500);  // the first drawing compiles shaders
  Project changed = session->project.document().project();
  double& angle = changed.joints[0].friction_angle;
  expectNoWait([&](const Watchdog&) {
    ASSERT_TRUE(waitForTheEstimate()) << said().toStdString();
    angle += 1;
    session->project.document().change(changed, {});
    EXPECT_EQ(said(), QStringLiteral("This run: estimating…"));
  });
  ASSERT_TRUE(waitForTheEstimate());
  const QRegularExpression words(
      QStringLiteral("^This run: about [0-9].* \\([0-9].* to [0-9].*\\), [0-9]+ MB, error about "));
  EXPECT_TRUE(words.match(said()).hasMatch()) << said().toStdString();
  rest(100);
  keepPicture(*window, "cost_ahead.png");
  theme::install(true);
  session->display.setDark(true);
  rest(300);
  keepPicture(*window, "cost_ahead_dark.png");
  theme::install(false);

  angle = 25;
  session->project.document().change(changed, {});
  EXPECT_EQ(said(), QStringLiteral("This run: estimating…"));
  angle = 26;
  session->project.document().change(changed, {});
  ASSERT_TRUE(waitForTheEstimate());
}

TEST_F(CostAheadTest, HasItsErrorFromTheStudyOfTheProject) {
  const auto file = slidingCube(100);
  study(file);
  openAndMesh(file);
  ASSERT_TRUE(session->project.study());
  session->display.goTo(WorkflowPage::solve);
  ASSERT_TRUE(waitForTheEstimate());
  const auto error = session->project.study()->study.rows[0].error;
  ASSERT_TRUE(error);
  EXPECT_TRUE(said().contains(QString::fromStdString("error about " + error_text(*error)))) << said().toStdString();
}

TEST_F(CostAheadTest, MakesRoomForTheRun) {
  openAndMesh(slidingCube());
  session->display.goTo(WorkflowPage::solve);
  const auto* ahead = window->findChild<CostAhead*>();
  EXPECT_TRUE(ahead->job().isBusy());
  session->solve();
  EXPECT_FALSE(ahead->isVisible());
  ASSERT_TRUE(wait([&] { return session->run.steps().size() > 5 && !ahead->job().isBusy(); }));
  session->run.job().stop();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
}

TEST_F(CostAheadTest, SaysWhatItTookOnceTheProjectWasRun) {
  openAndMesh(slidingCube(5));
  session->display.goTo(WorkflowPage::solve);
  EXPECT_EQ(said(), QStringLiteral("This run: estimating…"));
  session->solve();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy() && session->playback.frame(); }));
  session->display.goTo(WorkflowPage::solve);
  const auto* ahead = window->findChild<CostAhead*>();
  ASSERT_TRUE(ahead->isVisible());
  EXPECT_TRUE(said().startsWith(QStringLiteral("This run took "))) << said().toStdString();
  EXPECT_FALSE(ahead->job().isBusy()) << "nothing is left to be foreseen";
  window->open(folder / "cube.results");
  ASSERT_TRUE(wait([&] { return session->playback.frame() != nullptr; }));
  session->display.goTo(WorkflowPage::solve);
  EXPECT_TRUE(said().startsWith(QStringLiteral("This run took "))) << "of results: " << said().toStdString();

  Project changed = session->project.document().project();
  changed.joints[0].friction_angle += 1;
  session->project.document().change(changed, {});
  EXPECT_FALSE(said().startsWith(QStringLiteral("This run took "))) << "another run: " << said().toStdString();
  session->project.document().undoStack().undo();
  EXPECT_TRUE(said().startsWith(QStringLiteral("This run took "))) << "as it was run: " << said().toStdString();
}

}  // namespace
}  // namespace talus
