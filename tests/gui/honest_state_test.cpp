// What the window says of a run must be so: ticks, words and legends tell what is, not what was hoped for.
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <fstream>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "widgets/blocks/blocks_panel.hpp"
#include "widgets/results/export_strip.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/view/timeline.hpp"
#include "widgets/window/rail.hpp"
#include "widgets/window/workflow_bar.hpp"

namespace talus {
namespace {

class HonestState : public DrivenWindow {
 protected:
  RailItem::State tick(const char* page) {
    return window->findChild<RailItem*>(QStringLiteral("rail-") + QLatin1String(page))->state();
  }
  QString tipOf(const char* page) {
    return window->findChild<RailItem*>(QStringLiteral("rail-") + QLatin1String(page))->toolTip();
  }
  /// The sliding cube, with what it is expected to come to.
  std::filesystem::path expecting(const std::string& value) {
    const auto file = slidingCube(40);
    std::ifstream stream(file);
    std::string words{std::istreambuf_iterator<char>(stream), {}};
    words.insert(words.rfind('}'), R"(, "expect": [{"quantity": "P1.displacement.x", "time": 0.08, "value": )" + value +
                                       R"(, "tolerance": 0.2}])");
    return write("expecting.talus", words);
  }
  void solve() {
    session->solve();
    ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  }
  QImage view() {
    rest(600);  // until it is still
    return window->viewport().grab().toImage();
  }
};

TEST_F(HonestState, AnExpectedValueThatIsMissedIsAProblemAndNoTick) {
  window->open(expecting("5"));
  QStringList log;
  QObject::connect(&session->messages, &Messages::logged, [&](const QString& line) { log << line; });
  solve();
  EXPECT_EQ(tick("solve"), RailItem::State::doubtful);
  EXPECT_EQ(tick("results"), RailItem::State::doubtful);
  EXPECT_TRUE(tipOf("results").contains(QStringLiteral("1 of 1 expected values missed")))
      << tipOf("results").toStdString();
  ASSERT_EQ(session->messages.problems().size(), 1u);
  EXPECT_EQ(session->messages.problems()[0].place, QStringLiteral("P1.displacement.x"));
  EXPECT_FALSE(log.contains(QStringLiteral("run finished")));
  rest(300);
  keepPicture(*window, "missed_expectation.png");
}

TEST_F(HonestState, AnExpectedValueThatComesOutIsATick) {
  window->open(expecting("0.0104"));  // g (sin 30° − tan 10° cos 30°) t² / 2
  solve();
  EXPECT_EQ(tick("results"), RailItem::State::done) << tipOf("results").toStdString();
  EXPECT_TRUE(session->messages.problems().empty());
}

TEST_F(HonestState, AnotherBodyTakesTheTicksOfBlocksAndMeshAndMarksTheTable) {
  openAndMesh(slidingCube(40));
  session->display.goTo(WorkflowPage::blocks);
  EXPECT_EQ(tick("blocks"), RailItem::State::done);
  const auto* table = window->findChild<BlocksPanel*>();
  QString title;
  QObject::connect(table, &BlocksPanel::titleChanged, [&](const QString& words) { title = words; });
  Project changed = session->project.document().project();
  changed.solids[1].body = BodyKind::rigid;
  session->project.document().change(changed, QStringLiteral("make the block rigid"));
  for (const char* page : {"blocks", "mesh"}) {
    EXPECT_EQ(tick(page), RailItem::State::open) << page;
    EXPECT_TRUE(tipOf(page).contains(QStringLiteral("Changed since it was cut"))) << page;
  }
  EXPECT_EQ(title, QStringLiteral("Blocks, before the last change"));
  auto* primary = window->findChild<QPushButton*>(QStringLiteral("primary"));
  EXPECT_EQ(primary->text(), QStringLiteral("Cut and mesh")) << "what is to be done next";
  rest(300);
  keepPicture(*window, "stale_blocks.png");
  session->project.document().undoStack().undo();
  EXPECT_EQ(tick("blocks"), RailItem::State::done);
  EXPECT_EQ(title, QStringLiteral("Blocks"));
}

TEST_F(HonestState, APageOnWhichAnErrorIsHasNoTick) {
  window->open(write("lost.talus", R"({"talus": 1, "joints": {"J1": {"friction_angle": 30}}, "default_joint": "J1",
    "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.25}},
    "solids": [{"name": "hill", "file": "nowhere.step", "material": "rock"}],
    "stages": [{"name": "go", "type": "dynamic", "time_step": 0.01, "steps": 1}]})"));
  ASSERT_TRUE(wait([&] { return tick("geometry") == RailItem::State::doubtful; }));
  EXPECT_TRUE(tipOf("geometry").contains(QStringLiteral("no such file"))) << tipOf("geometry").toStdString();
  for (const char* page : {"joints", "materials", "stages"}) EXPECT_EQ(tick(page), RailItem::State::done) << page;
  Project mended = session->project.document().project();
  mended.solids[0].shape = BoxShape{{0, 0, 0}, {1, 1, 1}};
  session->project.document().change(mended, QStringLiteral("a box"));
  EXPECT_TRUE(wait([&] { return tick("geometry") == RailItem::State::done; }));
}

TEST_F(HonestState, CutAndMeshWaitsUntilTheSolidsHaveBeenRead) {
  window->open(sample("step_slope"));
  ASSERT_TRUE(session->surfaces.isBusy() && !session->surfaces.current());
  auto* primary = window->findChild<QPushButton*>(QStringLiteral("primary"));
  const auto buttons = window->viewport().findChildren<QPushButton*>();
  const auto inView = std::ranges::find_if(
      buttons, [](const QPushButton* one) { return one->text() == QStringLiteral("Cut and mesh"); });
  ASSERT_NE(inView, buttons.end());
  for (const QPushButton* one : {primary, *inView}) {
    EXPECT_FALSE(one->isEnabled());
    EXPECT_TRUE(one->toolTip().contains(QStringLiteral("The solids are being read"))) << one->toolTip().toStdString();
  }
  ASSERT_TRUE(wait([&] { return session->surfaces.current() && !session->surfaces.isBusy(); }));
  rest(20);
  EXPECT_TRUE(primary->isEnabled()) << primary->toolTip().toStdString();
  EXPECT_EQ(primary->text(), QStringLiteral("Cut and mesh"));
}

TEST_F(HonestState, AStoppedRunIsNoTickNeitherWhenItsResultsAreOpened) {
  openAndMesh(slidingCube());
  session->solve();
  ASSERT_TRUE(wait([&] { return session->run.steps().size() >= 20; }));
  session->run.job().stop();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  EXPECT_EQ(tick("results"), RailItem::State::doubtful);
  EXPECT_TRUE(tipOf("solve").contains(QStringLiteral("Stopped at"))) << tipOf("solve").toStdString();
  const auto results = session->playback.folder();
  window->open(results);
  ASSERT_TRUE(wait([&] { return session->playback.frame() != nullptr; }));
  EXPECT_EQ(tick("results"), RailItem::State::doubtful);
}

TEST_F(HonestState, CancellingAFilmLeavesTheViewAsItWas) {
  openAndMesh(slidingCube(400));
  solve();
  window->timeline().goToFirst();
  ASSERT_TRUE(wait([&] { return session->playback.frame()->index == 0; }));
  const QImage first = view();
  window->timeline().goToLast();
  ASSERT_TRUE(wait([&] { return session->playback.frame()->index > 30; }));
  const QImage last = view();
  ASSERT_NE(first, last);
  bool asked = false;
  QObject::connect(&window->exporter(), &ExportJob::progressed, [&] {
    if (!std::exchange(asked, true)) click(button(*window->findChild<ExportStrip*>(), "Cancel"));
  });
  window->saveFilm(folder / "film.mp4");
  ASSERT_TRUE(wait([&] { return !window->exporter().isBusy(); }));
  EXPECT_FALSE(std::filesystem::exists(folder / "film.mp4"));
  EXPECT_EQ(view(), last);
  window->timeline().goToFirst();
  ASSERT_TRUE(wait([&] { return session->playback.frame()->index == 0; }));
  EXPECT_EQ(view(), first) << "it goes on following the timeline";
  window->timeline().goToLast();
  ASSERT_TRUE(wait([&] { return session->playback.frame()->index > 30; }));
  EXPECT_EQ(view(), last) << "and reads what is there";
}

TEST_F(HonestState, TheLegendOfOpenedResultsSpansAllTheirFramesWhicheverWereLookedAt) {
  openAndMesh(slidingCube(400));
  solve();
  const auto results = session->playback.folder();
  openWindow();
  window->open(results);
  ASSERT_TRUE(wait([&] { return session->playback.frame() != nullptr; }));
  window->timeline().goToFirst();
  ASSERT_TRUE(wait([&] { return session->playback.frame()->index == 0; }));
  SceneSettings display = session->display.settings();
  display.field = field_named("displacement");
  session->display.set(display);
  ASSERT_TRUE(wait([&] { return session->display.settings().range && session->display.settings().range->high > 1; }))
      << "at the end the cube has slid 1.09 m";
  const double whole = session->display.settings().range->high;
  window->timeline().goToLast();
  ASSERT_TRUE(wait([&] { return session->playback.frame()->index == 40; }));
  EXPECT_EQ(session->display.settings().range->high, whole);
}

TEST_F(HonestState, AFileThatCannotBeWrittenIsNamedUntilItIsWrittenElsewhere) {
  window->open(slidingCube(40));
  const auto nowhere = folder / "no such folder" / "slope.talus";
  EXPECT_FALSE(session->project.saveAs(nowhere));
  auto* strip = window->findChild<QWidget*>(QStringLiteral("problem-strip"));
  EXPECT_TRUE(strip->isVisible());
  ASSERT_EQ(session->messages.problems().size(), 1u);
  EXPECT_TRUE(session->messages.problems()[0].place.contains(QString::fromStdString(nowhere.string())));
  EXPECT_TRUE(session->project.saveAs(folder / "slope.talus"));
  EXPECT_FALSE(strip->isVisible());
  EXPECT_TRUE(session->messages.problems().empty());
}

TEST_F(HonestState, ARemedyCanBeDoneInTheWindow) {
  window->open(slidingCube(40));
  std::filesystem::create_directories(folder / "cube.results");
  write("cube.results/letter.txt", "not of Talus");
  session->solve();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
  ASSERT_EQ(session->messages.problems().size(), 1u);
  EXPECT_TRUE(session->messages.problems()[0].place.endsWith(QStringLiteral("cube.results")));
  EXPECT_FALSE(session->messages.problems()[0].remedy.contains(QStringLiteral("--")));
}

TEST_F(HonestState, DamagedResultsLeaveOpenWhatIsOpen) {
  const auto file = slidingCube(400);
  openAndMesh(file);
  solve();
  const auto results = folder / "copy.results";
  std::filesystem::copy(session->playback.folder(), results, std::filesystem::copy_options::recursive);
  std::filesystem::resize_file(results / "results.h5", std::filesystem::file_size(results / "results.h5") / 3);
  window->open(sample("free_fall"));
  window->open(results);
  ASSERT_TRUE(wait([&] { return !session->messages.problems().empty(); }));
  EXPECT_EQ(session->project.document().name(), QStringLiteral("Free fall"));
  const Problem& problem = session->messages.problems()[0];
  EXPECT_TRUE(problem.place.contains(QStringLiteral("copy.results"))) << problem.place.toStdString();
  EXPECT_TRUE(problem.problem.startsWith(QStringLiteral("the file is damaged or was cut off")))
      << problem.problem.toStdString();
  EXPECT_FALSE(session->isOpening());
}

TEST_F(HonestState, APictureThatIsSavedWhileAFilmIsWrittenWaitsForItsTurn) {
  openAndMesh(slidingCube(400));
  solve();
  window->saveFilm(folder / "film.mp4", {.width = 320});
  window->savePicture(folder / "picture.png", 320);
  EXPECT_TRUE(window->exporter().isBusy());
  ASSERT_TRUE(wait([&] { return !window->exporter().isBusy(); }));
  EXPECT_TRUE(std::filesystem::exists(folder / "film.mp4"));
  EXPECT_TRUE(std::filesystem::exists(folder / "picture.png"));
  EXPECT_TRUE(session->run.whyNotSolve().isEmpty());
}

}  // namespace
}  // namespace talus
