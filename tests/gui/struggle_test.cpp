#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "widgets/step_facts.hpp"
#include "widgets/struggle_panel.hpp"
#include "widgets/theme.hpp"

namespace talus {
namespace {

/// A cube that drops on a base, with too few iterations for the blow: its steps are cut again and again, and with
/// `limit` 2 in vain.
std::string droppedCube(int limit, int steps) {
  return R"({
  "talus": 1, "name": "Dropped cube", "gravity": [0, 0, -9.81],
  "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.25}},
  "joints": {"J1": {"friction_angle": 30}},
  "default_joint": "J1",
  "solids": [
    {"name": "base", "box": {"min": [0, 0, 0], "max": [8, 6, 1]}, "material": "rock", "body": "fixed", "mesh_size": 2},
    {"name": "cube", "box": {"min": [2, 2, 1.05], "max": [4, 4, 3.05]}, "material": "rock", "mesh_size": 1}],
  "solver": {"open_close_limit": )" +
         std::to_string(limit) + R"(},
  "stages": [{"name": "drop", "type": "dynamic", "time_step": 0.002, "steps": )" +
         std::to_string(steps) + R"(}],
  "output": {"every": 0.02}
})";
}

QStringList saidIn(const QWidget& widget) {
  QStringList words;
  for (const auto* label : widget.findChildren<QLabel*>())
    if (label->isVisible()) words << label->text();
  return words;
}

StrugglePanel* panelInView(const MainWindow& window) {
  for (auto* panel : window.findChildren<StrugglePanel*>())
    if (panel->isVisible()) return panel;
  return nullptr;
}

TEST_F(DrivenWindow, ARunThatDoesNotConvergeIsShownWhereItStruggles) {
  openAndMesh(write("dropped.talus", droppedCube(2, 150)));
  EXPECT_EQ(panelInView(*window), nullptr) << "nothing to say before the run";
  workspace->solve();
  ASSERT_TRUE(wait([&] { return workspace->step() == Step::results && workspace->frame(); }));
  ASSERT_FALSE(workspace->struggles().empty());
  EXPECT_TRUE(workspace->struggles()[0].ended_run);
  rest(600);
  keepPicture(*window, "struggle_ended.png");

  StrugglePanel* panel = panelInView(*window);
  ASSERT_NE(panel, nullptr);
  EXPECT_TRUE(saidIn(*panel).contains(QString::fromUtf8("base – cube, joint J1")));
  EXPECT_GE(saidIn(*panel).filter(QStringLiteral("open_close_limit")).size(), 1);

  auto* strip = window->findChild<QWidget*>(QStringLiteral("problem-strip"));
  ASSERT_TRUE(strip->isVisible());
  const CameraPose before = *window->viewport().pose();
  click(button(*strip, "Show in view"));
  EXPECT_EQ(workspace->selection().blocks(), (std::vector<int>{0, 1}));
  ASSERT_TRUE(wait([&] { return !window->viewport().isFlying(); }));
  const CameraPose after = *window->viewport().pose();
  EXPECT_LT((after.focal_point - workspace->struggles()[0].position).norm(), 0.1);
  EXPECT_LT((after.position - after.focal_point).norm(), (before.position - before.focal_point).norm());
  rest(600);
  keepPicture(*window, "struggle_shown.png");
  window->viewport().fit();
  click(button(*panel, "Show"));
  ASSERT_TRUE(wait([&] { return !window->viewport().isFlying(); }));
  EXPECT_LT((window->viewport().pose()->focal_point - workspace->struggles()[0].position).norm(), 0.1);

  const auto results = workspace->resultsFolder();
  window->open(results);
  ASSERT_TRUE(wait([&] { return workspace->frame() != nullptr; }));
  ASSERT_FALSE(workspace->struggles().empty()) << "opened results tell the same";
  EXPECT_NE(panelInView(*window), nullptr);
  workspace->setDark(true);
  workspace->goTo(Step::solve);
  rest(600);
  keepPicture(*window, "struggle_opened_dark.png");
  workspace->setDark(false);
}

TEST_F(DrivenWindow, ANewRunBeginsWithoutTheTroublesOfTheOneBefore) {
  openAndMesh(write("dropped.talus", droppedCube(2, 150)));
  workspace->solve();
  ASSERT_TRUE(wait([&] { return workspace->step() == Step::results && workspace->frame(); }));
  auto* strip = window->findChild<QWidget*>(QStringLiteral("problem-strip"));
  EXPECT_TRUE(strip->isVisible());
  workspace->goTo(Step::solve);
  const auto words = saidIn(*window->findChild<StepFacts*>());
  EXPECT_EQ(words.filter(QStringLiteral("not settled")).size(), 1) << words.join(u'|').toStdString();
  for (const auto* bar : window->findChildren<QProgressBar*>())
    if (bar->accessibleName() == QStringLiteral("Share of the run that is done")) {
      EXPECT_EQ(bar->value(), static_cast<int>(1000 * workspace->steps().back().time / 0.3));
    }
  const auto* ahead = window->findChild<QLabel*>(QStringLiteral("cost-ahead"));
  EXPECT_TRUE(wait([&] { return ahead->text().contains(QStringLiteral("will not converge")); }, 20000))
      << "the same again: " << ahead->text().toStdString();
  rest(300);
  keepPicture(*window, "struggle_failed_step.png");
  theme::install(true);
  workspace->setDark(true);
  rest(300);
  keepPicture(*window, "struggle_failed_step_dark.png");
  theme::install(false);
  workspace->setDark(false);

  workspace->solve();
  workspace->job().pause();
  EXPECT_TRUE(workspace->struggles().empty());
  EXPECT_EQ(panelInView(*window), nullptr);
  EXPECT_FALSE(strip->isVisible());
  EXPECT_TRUE(workspace->problems().empty());
  rest(300);
  keepPicture(*window, "struggle_new_run.png");
  workspace->job().stop();
  ASSERT_TRUE(wait([&] { return !workspace->job().isBusy(); }));
}

TEST_F(DrivenWindow, ARunThatGoesOnSaysWhereItStrugglesMeanwhile) {
  openAndMesh(write("dropped.talus", droppedCube(3, 100000)));
  workspace->solve();
  ASSERT_TRUE(wait([&] { return !workspace->struggles().empty(); }));
  EXPECT_EQ(workspace->struggles()[0].blocks[1], "cube");
  EXPECT_GT(workspace->struggles()[0].cuts, 0);
  rest(800);
  ASSERT_TRUE(workspace->job().isBusy());
  EXPECT_NE(panelInView(*window), nullptr);
  keepPicture(*window, "struggle_live.png");
  workspace->job().stop();
  ASSERT_TRUE(wait([&] { return !workspace->job().isBusy(); }));
  EXPECT_FALSE(workspace->struggles().empty());
  window->open(slidingCube(5));
  EXPECT_TRUE(workspace->struggles().empty()) << "another project, other troubles";
}

}  // namespace
}  // namespace talus
