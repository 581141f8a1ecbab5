#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include <fstream>

#include "driven_window.hpp"
#include "widgets/run/effect_list.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/view/timeline.hpp"
#include "widgets/window/window_actions.hpp"

namespace talus {
namespace {

TEST_F(DrivenWindow, OpensASampleRunsPausesResumesStopsScrubsAndSaves) {
  openAndMesh(slidingCube());
  EXPECT_EQ(session->project.system()->blocks.size(), 2u);

  session->solve();
  EXPECT_EQ(session->display.page(), WorkflowPage::solve);
  ASSERT_TRUE(wait([&] { return session->run.steps().size() >= 20; }));

  session->run.job().pause();
  int deliveries = 0;  // the first two may still hold steps made before the pause
  const auto counting = QObject::connect(&session->run.job(), &SolverJob::newsArrived, [&] { ++deliveries; });
  ASSERT_TRUE(wait([&] { return deliveries >= 3; }));
  QObject::disconnect(counting);
  const size_t paused = session->run.steps().size();
  rest(300);
  EXPECT_EQ(session->run.steps().size(), paused);
  session->run.job().oneStep();
  ASSERT_TRUE(wait([&] { return session->run.steps().size() == paused + 1; }));

  session->run.job().resume();
  ASSERT_TRUE(wait([&] { return session->run.steps().size() > paused + 20 && session->playback.times().size() > 4; }));
  session->run.job().stop();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
  ASSERT_TRUE(session->run.report().has_value());
  EXPECT_EQ(session->run.report()->status, RunStatus::stopped);

  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  EXPECT_FALSE(session->playback.isLive());
  const int last = static_cast<int>(session->playback.times().size()) - 1;
  ASSERT_GT(last, 2);
  session->playback.showFrame(2);
  ASSERT_TRUE(wait([&] { return session->playback.frame()->index == 2; }));
  EXPECT_DOUBLE_EQ(session->playback.time(), session->playback.times()[2]);
  window->timeline().stepBy(-1);
  ASSERT_TRUE(wait([&] { return session->playback.frame()->index == 1; }));

  SceneSettings display = session->display.settings();
  display.field = field_named("velocity");
  session->display.set(display);
  window->timeline().goToLast();
  ASSERT_TRUE(wait([&] { return session->playback.frame()->index == last; }));
  ASSERT_TRUE(session->display.settings().range.has_value());
  EXPECT_GT(session->display.settings().range->high, 0.01);  // the cube moves

  window->savePicture(folder / "picture.png");
  ASSERT_TRUE(wait([&] { return !window->exporter().isBusy(); }));
  const QImage picture(QString::fromStdString((folder / "picture.png").string()));
  EXPECT_EQ(picture.width(), 1920);

  window->saveFilm(folder / "film.mp4");
  EXPECT_FALSE(session->run.whyNotSolve().isEmpty()) << "a run would replace the results that the film reads";
  ASSERT_TRUE(wait([&] { return !window->exporter().isBusy(); }));
  EXPECT_GT(std::filesystem::file_size(folder / "film.mp4"), 2000u);
  EXPECT_TRUE(session->run.whyNotSolve().isEmpty());
  EXPECT_TRUE(session->messages.problems().empty());
}

TEST_F(DrivenWindow, GoesOnWithAStoppedRunWhereItWasStopped) {
  openAndMesh(slidingCube());
  auto* goOn = window->findChild<QPushButton*>("goOn");
  EXPECT_TRUE(goOn->isHidden());
  session->solve();
  ASSERT_TRUE(wait([&] { return session->run.steps().size() >= 20; }));
  session->run.job().stop();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy() && session->run.checkpoint(); }));
  const std::vector<StepReport> before = session->run.steps();
  EXPECT_NEAR(*session->run.checkpoint(), before.back().time, 1e-9);
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));

  Project longer = session->project.document().project();
  longer.stages.back().time_step *= 2;
  session->project.document().change(longer, QStringLiteral("longer steps"));
  EXPECT_FALSE(session->run.checkpoint()) << "another project";
  session->project.document().undoStack().undo();
  ASSERT_TRUE(session->run.checkpoint());

  session->display.goTo(WorkflowPage::solve);
  ASSERT_TRUE(wait([&] { return goOn->isVisible(); }));
  QTest::mouseClick(goOn, Qt::LeftButton);
  ASSERT_TRUE(wait([&] { return session->run.steps().size() > before.size() + 20; }));
  EXPECT_TRUE(goOn->isHidden()) << "it goes on";
  for (std::size_t i = 0; i < session->run.steps().size(); ++i)
    ASSERT_EQ(session->run.steps()[i].step, static_cast<int>(i) + 1);
  session->run.job().stop();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy() && session->playback.frame(); }));
  ASSERT_TRUE(wait([&] { return session->playback.times().front() == 0; })) << "all frames, those of before too";
  EXPECT_TRUE(session->messages.problems().empty());

  const auto file = session->project.document().file();
  const double checkpoint = *session->run.checkpoint();
  window = std::make_unique<MainWindow>();
  session = &window->session();
  window->open(file);
  ASSERT_TRUE(wait([&] { return session->run.checkpoint().has_value(); })) << "another day";
  EXPECT_EQ(*session->run.checkpoint(), checkpoint);
}

std::string startOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(16, '\0');
  stream.read(bytes.data(), 16);
  return bytes;
}

TEST_F(DrivenWindow, HandsOverReportsAndDataOfResults) {
  openAndMesh(slidingCube(60));
  auto* report = window->findChild<WindowActions*>()->saveReport;
  EXPECT_FALSE(report->isEnabled());
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  ASSERT_TRUE(wait([&] { return report->isEnabled(); }));
  window->saveReport(folder / "slide.html");
  window->saveReport(folder / "slide.pdf");
  window->exportData(DataFormat::csv, folder / "tables");
  window->exportData(DataFormat::vtu, folder / "vtu");
  window->exportData(DataFormat::stl, folder / "deposit.stl");
  window->exportData(DataFormat::gltf, folder / "slide.glb");
  ASSERT_TRUE(wait([&] { return !window->exporter().isBusy(); }, 60000));
  EXPECT_EQ(startOf(folder / "slide.html").substr(0, 15), "<!DOCTYPE html>");
  EXPECT_EQ(startOf(folder / "slide.pdf").substr(0, 5), "%PDF-");
  EXPECT_TRUE(std::filesystem::exists(folder / "tables" / "blocks.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "vtu" / "frames.pvd"));
  EXPECT_EQ((std::filesystem::file_size(folder / "deposit.stl") - 84) % 50, 0u);
  EXPECT_EQ(startOf(folder / "slide.glb").substr(0, 4), "glTF");
  EXPECT_TRUE(session->messages.problems().empty());

  window->exportData(DataFormat::csv, folder / "tables");
  ASSERT_TRUE(wait([&] { return !window->exporter().isBusy(); }));
  EXPECT_EQ(session->messages.problems().size(), 1u) << "the folder is not empty";
}

/// All that the list of effects says.
QStringList saidOfEffects(MainWindow& window) {
  QStringList said;
  for (const auto* label : window.findChild<EffectList*>()->findChildren<QLabel*>()) said << label->text();
  return said;
}

TEST_F(DrivenWindow, OpensResultsAndPlaysThem) {
  openAndMesh(slidingCube(200));
  ASSERT_TRUE(wait([&] { return !session->run.effectCosts().empty(); }));
  EXPECT_EQ(saidOfEffects(*window).front(), QStringLiteral("Effects: 12 of 20 on"));
  EXPECT_TRUE(saidOfEffects(*window).contains(QStringLiteral("no stage or material asks for it")));
  EXPECT_EQ(saidOfEffects(*window).filter(QStringLiteral(" contact points at the start")).size(), 7);
  EXPECT_EQ(saidOfEffects(*window).filter(QStringLiteral(" tetrahedra")).size(), 3);
  session->solve();
  ASSERT_TRUE(wait([&] { return session->run.effects().size() == 20 && session->playback.isLive(); }))
      << "as the run goes on";
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  EXPECT_TRUE(saidOfEffects(*window).contains(QStringLiteral("time spent")));
  const auto results = session->playback.folder();

  window = std::make_unique<MainWindow>();
  session = &window->session();
  window->resize(1280, 800);
  window->show();
  window->open(results);
  ASSERT_TRUE(wait([&] { return session->playback.frame() != nullptr; }));
  EXPECT_EQ(session->display.page(), WorkflowPage::results);
  EXPECT_EQ(session->playback.times().size(), 21u);  // 0.4 s, one every 0.02 s, and the start
  EXPECT_EQ(session->run.monitorNames(), std::vector<std::string>{"P1"});
  ASSERT_TRUE(session->run.report());
  EXPECT_EQ(session->run.report()->status, RunStatus::completed);
  EXPECT_EQ(saidOfEffects(*window).front(), QStringLiteral("Effects: 12 of 20 on"));
  EXPECT_TRUE(saidOfEffects(*window).contains(QStringLiteral("time spent")));
  window->timeline().togglePlay();
  EXPECT_TRUE(window->timeline().isPlaying());
  ASSERT_TRUE(wait([&] { return session->playback.number() == 20 && !window->timeline().isPlaying(); }, 10000));
}

TEST_F(DrivenWindow, TheTimelineNamesAStageWholeOrNotAtAll) {
  openAndMesh(slidingCube());
  Project changed = session->project.document().project();
  Stage settle = changed.stages.at(0);
  settle.name = "settle before it is let go";
  settle.steps = 12;
  changed.stages.insert(changed.stages.begin(), settle);
  session->project.document().change(changed, QStringLiteral("settle first"));
  session->solve();
  const auto& track = *window->findChild<TimelineTrack*>();
  const auto names = [&] {
    QStringList words;
    for (const auto& [place, name] : track.stageNames()) {
      EXPECT_TRUE(QRectF(track.rect()).contains(place)) << name.toStdString();
      words << name;
    }
    return words;
  };
  const auto stage = [&] { return session->run.steps().empty() ? -1 : session->run.steps().back().stage; };
  ASSERT_TRUE(wait([&] { return stage() == 1; }));
  EXPECT_EQ(names(), QStringList{"slide"}) << "12 of 4012 steps have no room for a name; what is to come has";
}

TEST_F(DrivenWindow, ReopensAProjectWithItsResultsUntilItIsEdited) {
  const auto file = slidingCube(50);
  openAndMesh(file);
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  window->open(file);
  ASSERT_TRUE(wait([&] { return session->playback.frame() != nullptr; }));
  EXPECT_TRUE(session->playback.isCurrent());
  Project changed = session->project.document().project();
  changed.joints[0].friction_angle = 40;
  session->project.document().change(changed, {});
  EXPECT_FALSE(session->playback.isCurrent());
  session->project.document().undoStack().undo();
  EXPECT_TRUE(session->playback.isCurrent()) << "what was edited is taken back";
  session->project.document().undoStack().redo();
  session->project.document().save();
  window->open(file);
  rest(200);
  EXPECT_EQ(session->display.page(), WorkflowPage::geometry);
  EXPECT_EQ(session->playback.frame(), nullptr);
}

TEST_F(DrivenWindow, NoEventWaitsATenthOfASecondWhileASolveRuns) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers make everything several times slower";
#endif
  warmUp();
  openAndMesh(slidingCube(100000));
  SceneSettings display = session->display.settings();
  display.field = field_named("displacement");
  session->display.set(display);
  session->solve();
  ASSERT_TRUE(wait([&] { return session->playback.times().size() > 2; }));
  rest(500);  // the first drawing compiles shaders
  const RenderSurface& surface = window->viewport().surface();
  const auto bars = window->findChild<EffectList*>()->findChildren<ShareBar*>();
  expectNoWait([&](const Watchdog& watchdog) {
    const int drawn = surface.drawings();
    ASSERT_TRUE(wait([&] { return watchdog.beats() > 400 && surface.drawings() > drawn + 4; }))
        << "the view must follow the run: " << surface.drawings() - drawn << " drawings";
  });
  EXPECT_TRUE(session->run.job().isBusy());
  ASSERT_EQ(bars.size(), 12);
  EXPECT_EQ(window->findChild<EffectList*>()->findChildren<ShareBar*>(), bars)
      << "rows that stay are not laid out anew by what they cost";
}

TEST_F(DrivenWindow, NoEventWaitsATenthOfASecondWhileJiweishanIsMeshedAndSolved) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers make everything several times slower";
#endif
  const auto file = sample("jiweishan");
  expectNoWait([&](Watchdog& watchdog) {
    openWindow();
    warmUp();
    window->open(file);
    rest(200);
    watchdog.restart();
    session->solve();
    ASSERT_TRUE(wait([&] { return session->run.steps().size() > 1000; }));
    EXPECT_TRUE(session->run.job().isBusy());
  });
}

}  // namespace
}  // namespace talus
