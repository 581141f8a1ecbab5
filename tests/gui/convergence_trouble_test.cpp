#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/run/step_facts.hpp"
#include "widgets/run/trouble_panel.hpp"

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

TroublePanel* panelInView(const MainWindow& window) {
  for (auto* panel : window.findChildren<TroublePanel*>())
    if (panel->isVisible()) return panel;
  return nullptr;
}

TEST_F(DrivenWindow, ARunThatDoesNotConvergeIsShownWhereItHasTrouble) {
  openAndMesh(write("dropped.talus", droppedCube(1, 150)));
  EXPECT_EQ(panelInView(*window), nullptr) << "nothing to say before the run";
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  ASSERT_FALSE(session->run.troubles().empty());
  EXPECT_TRUE(session->run.troubles()[0].ended_run);
  rest(600);
  keepPicture(*window, "trouble_ended.png");

  TroublePanel* panel = panelInView(*window);
  ASSERT_NE(panel, nullptr);
  EXPECT_TRUE(saidIn(*panel).contains(QString::fromUtf8("base – cube, joint J1")));
  EXPECT_GE(saidIn(*panel).filter(QString::fromUtf8("open–close limit"), Qt::CaseInsensitive).size(), 1);

  auto* strip = window->findChild<QWidget*>(QStringLiteral("problem-strip"));
  ASSERT_TRUE(strip->isVisible());
  const CameraPose before = *window->viewport().pose();
  click(button(*strip, "Show in view"));
  EXPECT_EQ(session->project.selection().blocks(), (std::vector<int>{0, 1}));
  ASSERT_TRUE(wait([&] { return !window->viewport().isFlying(); }));
  const CameraPose after = *window->viewport().pose();
  EXPECT_LT((after.focal_point - session->run.troubles()[0].position).norm(), 0.1);
  EXPECT_LT((after.position - after.focal_point).norm(), (before.position - before.focal_point).norm());
  rest(600);
  keepPicture(*window, "trouble_shown.png");
  window->viewport().fit();
  click(button(*panel, "Show"));
  ASSERT_TRUE(wait([&] { return !window->viewport().isFlying(); }));
  EXPECT_LT((window->viewport().pose()->focal_point - session->run.troubles()[0].position).norm(), 0.1);

  const auto results = session->playback.folder();
  window->open(results);
  ASSERT_TRUE(wait([&] { return session->playback.frame() != nullptr; }));
  ASSERT_FALSE(session->run.troubles().empty()) << "opened results tell the same";
  EXPECT_NE(panelInView(*window), nullptr);
  session->display.setDark(true);
  session->display.goTo(WorkflowPage::solve);
  rest(600);
  keepPicture(*window, "trouble_opened_dark.png");
  session->display.setDark(false);
}

TEST_F(DrivenWindow, ANewRunBeginsWithoutTheTroublesOfTheOneBefore) {
  openAndMesh(write("dropped.talus", droppedCube(1, 150)));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  auto* strip = window->findChild<QWidget*>(QStringLiteral("problem-strip"));
  EXPECT_TRUE(strip->isVisible());
  session->display.goTo(WorkflowPage::solve);
  const auto words = saidIn(*window->findChild<StepFacts*>());
  EXPECT_EQ(words.filter(QStringLiteral("not converged")).size(), 1) << words.join(u'|').toStdString();
  for (const auto* bar : window->findChildren<QProgressBar*>())
    if (bar->accessibleName() == QStringLiteral("Share of the run that is done")) {
      EXPECT_EQ(bar->value(), static_cast<int>(1000 * session->run.steps().back().time / 0.3));
    }
  const auto* ahead = window->findChild<QLabel*>(QStringLiteral("cost-ahead"));
  EXPECT_TRUE(wait([&] { return ahead->text().contains(QStringLiteral("will not converge")); }, 20000))
      << "the same again: " << ahead->text().toStdString();
  rest(300);
  keepPicture(*window, "trouble_failed_step.png");
  theme::install(true);
  session->display.setDark(true);
  rest(300);
  keepPicture(*window, "trouble_failed_step_dark.png");
  theme::install(false);
  session->display.setDark(false);

  session->solve();
  session->run.job().pause();
  EXPECT_TRUE(session->run.troubles().empty());
  EXPECT_EQ(panelInView(*window), nullptr);
  EXPECT_FALSE(strip->isVisible());
  EXPECT_TRUE(session->messages.problems().empty());
  rest(300);
  keepPicture(*window, "trouble_new_run.png");
  session->run.job().stop();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
}

TEST_F(DrivenWindow, ARunThatGoesOnSaysWhereItHasTroubleMeanwhile) {
  openAndMesh(write("dropped.talus", droppedCube(3, 100000)));
  session->solve();
  ASSERT_TRUE(wait([&] { return !session->run.troubles().empty(); }));
  EXPECT_EQ(session->run.troubles()[0].blocks[1], "cube");
  EXPECT_GT(session->run.troubles()[0].cuts, 0);
  rest(800);
  ASSERT_TRUE(session->run.job().isBusy());
  EXPECT_NE(panelInView(*window), nullptr);
  keepPicture(*window, "trouble_live.png");
  session->run.job().stop();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
  EXPECT_FALSE(session->run.troubles().empty());
  window->open(slidingCube(5));
  EXPECT_TRUE(session->run.troubles().empty()) << "another project, other troubles";
}

}  // namespace
}  // namespace talus
