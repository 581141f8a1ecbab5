#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QTest>

#include "driven_window.hpp"
#include "widgets/effect_list.hpp"
#include "widgets/timeline.hpp"

namespace talus {
namespace {

TEST_F(DrivenWindow, OpensASampleRunsPausesResumesStopsScrubsAndSaves) {
  openAndMesh(slidingCube());
  EXPECT_EQ(workspace->system()->blocks.size(), 2u);

  workspace->solve();
  EXPECT_EQ(workspace->step(), Step::solve);
  ASSERT_TRUE(wait([&] { return workspace->steps().size() >= 20; }));

  workspace->job().pause();
  int deliveries = 0;  // the first two may still hold steps made before the pause
  const auto counting = QObject::connect(&workspace->job(), &SolverJob::newsArrived, [&] { ++deliveries; });
  ASSERT_TRUE(wait([&] { return deliveries >= 3; }));
  QObject::disconnect(counting);
  const size_t paused = workspace->steps().size();
  rest(300);
  EXPECT_EQ(workspace->steps().size(), paused);
  workspace->job().oneStep();
  ASSERT_TRUE(wait([&] { return workspace->steps().size() == paused + 1; }));

  workspace->job().resume();
  ASSERT_TRUE(wait([&] { return workspace->steps().size() > paused + 20 && workspace->frameTimes().size() > 4; }));
  workspace->job().stop();
  ASSERT_TRUE(wait([&] { return !workspace->job().isBusy(); }));
  ASSERT_TRUE(workspace->report().has_value());
  EXPECT_EQ(workspace->report()->status, RunStatus::stopped);

  ASSERT_TRUE(wait([&] { return workspace->step() == Step::results && workspace->frame(); }));
  EXPECT_FALSE(workspace->isLive());
  const int last = static_cast<int>(workspace->frameTimes().size()) - 1;
  ASSERT_GT(last, 2);
  workspace->showFrame(2);
  ASSERT_TRUE(wait([&] { return workspace->frame()->index == 2; }));
  EXPECT_DOUBLE_EQ(workspace->time(), workspace->frameTimes()[2]);
  window->timeline().stepBy(-1);
  ASSERT_TRUE(wait([&] { return workspace->frame()->index == 1; }));

  SceneSettings display = workspace->display();
  display.field = field_named("velocity");
  workspace->setDisplay(display);
  window->timeline().goToLast();
  ASSERT_TRUE(wait([&] { return workspace->frame()->index == last; }));
  ASSERT_TRUE(workspace->display().range.has_value());
  EXPECT_GT(workspace->display().range->high, 0.01);  // the cube moves

  window->savePicture(folder / "picture.png");
  ASSERT_TRUE(wait([&] { return !window->exporter().isBusy(); }));
  const QImage picture(QString::fromStdString((folder / "picture.png").string()));
  EXPECT_EQ(picture.width(), 1920);

  window->saveFilm(folder / "film.mp4");
  EXPECT_FALSE(workspace->whyNotSolve().isEmpty()) << "a run would replace the results that the film reads";
  ASSERT_TRUE(wait([&] { return !window->exporter().isBusy(); }));
  EXPECT_GT(std::filesystem::file_size(folder / "film.mp4"), 2000u);
  EXPECT_TRUE(workspace->whyNotSolve().isEmpty());
  EXPECT_TRUE(workspace->problems().empty());
}

/// All that the list of effects says.
QStringList saidOfEffects(MainWindow& window) {
  QStringList said;
  for (const auto* label : window.findChild<EffectList*>()->findChildren<QLabel*>()) said << label->text();
  return said;
}

TEST_F(DrivenWindow, OpensResultsAndPlaysThem) {
  openAndMesh(slidingCube(200));
  ASSERT_TRUE(wait([&] { return !workspace->effectCosts().empty(); }));
  EXPECT_EQ(saidOfEffects(*window).front(), QStringLiteral("Effects: 5 of 12 on"));
  EXPECT_TRUE(saidOfEffects(*window).contains(QStringLiteral("no stage or material asks for it")));
  EXPECT_EQ(saidOfEffects(*window).filter(QStringLiteral(" contact points at the start")).size(), 2);
  EXPECT_EQ(saidOfEffects(*window).filter(QStringLiteral(" tetrahedra")).size(), 3);
  workspace->solve();
  ASSERT_TRUE(wait([&] { return workspace->effects().size() == 12 && workspace->isLive(); })) << "as the run goes on";
  ASSERT_TRUE(wait([&] { return workspace->step() == Step::results && workspace->frame(); }));
  EXPECT_TRUE(saidOfEffects(*window).contains(QStringLiteral("time spent")));
  const auto results = workspace->resultsFolder();

  window = std::make_unique<MainWindow>();
  workspace = &window->workspace();
  window->resize(1280, 800);
  window->show();
  window->open(results);
  ASSERT_TRUE(wait([&] { return workspace->frame() != nullptr; }));
  EXPECT_EQ(workspace->step(), Step::results);
  EXPECT_EQ(workspace->frameTimes().size(), 21u);  // 0.4 s, one every 0.02 s, and the start
  EXPECT_EQ(workspace->monitorNames(), std::vector<std::string>{"P1"});
  ASSERT_TRUE(workspace->report());
  EXPECT_EQ(workspace->report()->status, RunStatus::completed);
  EXPECT_EQ(saidOfEffects(*window).front(), QStringLiteral("Effects: 5 of 12 on"));
  EXPECT_TRUE(saidOfEffects(*window).contains(QStringLiteral("time spent")));
  window->timeline().togglePlay();
  EXPECT_TRUE(window->timeline().isPlaying());
  ASSERT_TRUE(wait([&] { return workspace->frameNumber() == 20 && !window->timeline().isPlaying(); }, 10000));
}

TEST_F(DrivenWindow, ReopensAProjectWithItsResultsUntilItIsEdited) {
  const auto file = slidingCube(50);
  openAndMesh(file);
  workspace->solve();
  ASSERT_TRUE(wait([&] { return workspace->step() == Step::results && workspace->frame(); }));
  window->open(file);
  ASSERT_TRUE(wait([&] { return workspace->frame() != nullptr; }));
  EXPECT_TRUE(workspace->resultsAreCurrent());
  Joint joint = workspace->document().project().joints[0];
  joint.friction_angle = 40;
  workspace->document().changeJoint(0, joint);
  EXPECT_FALSE(workspace->resultsAreCurrent());
  workspace->document().save();
  window->open(file);
  rest(200);
  EXPECT_EQ(workspace->step(), Step::geometry);
  EXPECT_EQ(workspace->frame(), nullptr);
}

TEST_F(DrivenWindow, NoEventWaitsATenthOfASecondWhileASolveRuns) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers make everything several times slower";
#endif
  openAndMesh(slidingCube(100000));
  SceneSettings display = workspace->display();
  display.field = field_named("displacement");
  workspace->setDisplay(display);
  workspace->solve();
  ASSERT_TRUE(wait([&] { return workspace->frameTimes().size() > 2; }));
  rest(500);  // the first drawing compiles shaders
  const RenderSurface& surface = window->viewport().surface();
  expectNoWait([&](const Watchdog& watchdog) {
    const int drawn = surface.drawings();
    ASSERT_TRUE(wait([&] { return watchdog.beats() > 400 && surface.drawings() > drawn + 4; }))
        << "the view must follow the run: " << surface.drawings() - drawn << " drawings";
  });
  EXPECT_TRUE(workspace->job().isBusy());
}

TEST_F(DrivenWindow, NoEventWaitsATenthOfASecondWhileJiweishanIsMeshedAndSolved) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers make everything several times slower";
#endif
  const auto file = sample("jiweishan");
  expectNoWait([&](Watchdog& watchdog) {
    openWindow();
    window->open(file);
    rest(200);
    watchdog.restart();
    workspace->solve();
    ASSERT_TRUE(wait([&] { return workspace->steps().size() > 1000; }));
    EXPECT_TRUE(workspace->job().isBusy());
  });
}

TEST_F(DrivenWindow, ClosingStopsTheRunFirst) {
  openAndMesh(slidingCube());
  workspace->solve();
  ASSERT_TRUE(wait([&] { return workspace->steps().size() > 5; }));
  window->close();
  EXPECT_TRUE(window->isVisible());
  ASSERT_TRUE(wait([&] { return !window->isVisible(); }));
  EXPECT_FALSE(workspace->job().isBusy());
}

}  // namespace
}  // namespace talus
