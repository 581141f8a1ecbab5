// What is drawn over results, how films are moved through, and what is seen of a run from its first second on.
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabBar>

#include "answers.hpp"
#include "driven_window.hpp"
#include "widgets/results/display_panel.hpp"
#include "widgets/results/film_dialog.hpp"
#include "widgets/results/line_panel.hpp"
#include "widgets/results/slipped_joints_panel.hpp"
#include "widgets/window/bottom_panel.hpp"
#include "widgets/window/window_actions.hpp"

namespace talus {
namespace {

class Watching : public DrivenWindow {
 protected:
  void solveSlide(int steps = 100) {
    openAndMesh(slidingCube(steps));
    session->solve();
    ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
    ASSERT_TRUE(wait([&] { return !session->playback.isLive() && !session->playback.folder().empty(); }));
    rest(500);
  }

  template <class Widget>
  Widget& named(const QWidget& in, const QString& name) {
    for (auto* widget : in.findChildren<Widget*>())
      if (widget->accessibleName() == name || widget->property("text").toString() == name) return *widget;
    throw std::runtime_error("there is no " + name.toStdString());
  }

  static void choose(QComboBox& box, const QString& entry) {
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_Home);
    for (int tries = 0; tries < box.count() && box.currentText() != entry; ++tries) QTest::keyClick(&box, Qt::Key_Down);
    ASSERT_EQ(box.currentText(), entry);
  }

  QImage seen() {
    rest(300);
    return window->viewport().picture().toImage();
  }
};

TEST_F(Watching, TrailsOfAllOrOfSelectedBlocksAreDrawn) {
  solveSlide();
  const QImage without = seen();
  auto& panel = *window->findChild<DisplayPanel*>();
  auto& trails = named<QComboBox>(panel, QStringLiteral("Trails"));
  choose(trails, QStringLiteral("all blocks"));
  ASSERT_TRUE(wait([&] { return session->trails.trails() != nullptr; }));
  EXPECT_EQ(session->trails.trails()->times.size(), session->playback.times().size());
  const QImage all = seen();
  EXPECT_NE(all, without);
  keepPicture(*window, "trails.png");
  choose(trails, QStringLiteral("selected blocks"));
  EXPECT_EQ(seen(), without) << "nothing is selected";
  window->savePicture(folder / "without.png", 640);
  ASSERT_TRUE(wait([&] { return !window->exporter().isBusy(); }));
  session->project.selection().selectBlocks({1});
  EXPECT_NE(seen(), without);
  window->savePicture(folder / "with.png", 640);
  ASSERT_TRUE(wait([&] { return !window->exporter().isBusy(); }));
  EXPECT_NE(QImage(QString::fromStdString((folder / "with.png").string())),
            QImage(QString::fromStdString((folder / "without.png").string())));
  session->project.selection().selectBlocks({});
  choose(trails, QStringLiteral("none"));
  EXPECT_EQ(seen(), without);
}

TEST_F(Watching, TrailsGrowWhileARunGoesOnAndStayWhenItEnds) {
  openAndMesh(slidingCube(2000));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->playback.times().size() >= 5; }));
  session->run.job().pause();
  session->display.goTo(WorkflowPage::results);
  choose(named<QComboBox>(*window->findChild<DisplayPanel*>(), QStringLiteral("Trails")), QStringLiteral("all blocks"));
  ASSERT_TRUE(session->playback.isLive());
  ASSERT_TRUE(session->trails.trails());
  const std::size_t first = session->trails.trails()->times.size();
  EXPECT_GE(first, 5u);
  rest(300);
  keepPicture(*window, "live_trails.png");
  session->run.job().resume();
  ASSERT_TRUE(wait([&] { return session->trails.trails()->times.size() > first + 3; }));
  session->run.job().stop();
  while (!session->trails.isBusy() && session->run.job().isBusy()) {
    EXPECT_TRUE(session->trails.trails()) << "as it ends";
    rest(5);
  }
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy() && !session->playback.folder().empty(); }));
  ASSERT_TRUE(wait([&] {
    return session->trails.trails() && session->trails.trails()->times == session->playback.times() &&
           !session->trails.isBusy();
  }));
}

TEST_F(Watching, AxesOfRotationAreSwitchedOn) {
  solveSlide();
  auto& box = named<QCheckBox>(*window->findChild<DisplayPanel*>(), QStringLiteral("Axes of rotation"));
  QTest::mouseClick(&box, Qt::LeftButton, {}, QPoint(8, box.height() / 2));
  EXPECT_TRUE(session->display.settings().turning_axes);
}

TEST_F(Watching, AProbedLineIsSeenInTheViewUntilItIsTakenAway) {
  solveSlide();
  const QImage without = seen();
  auto* tabs = window->findChild<BottomPanel*>();
  auto* panel = tabs->findChild<LinePanel*>();
  tabs->setCurrentWidget(panel);
  QTest::mouseClick(&named<QPushButton>(*panel, QStringLiteral("Choose two points")), Qt::LeftButton);
  PickedPlace begin, end;
  begin.point = Vec3(0.5, 2, 4);
  end.point = Vec3(9.5, 2, 2);
  session->picking.take(begin);
  session->picking.take(end);
  ASSERT_TRUE(session->display.settings().probed_line);
  EXPECT_NE(seen(), without);
  keepPicture(*window, "probed_line.png");
  window->saveView(folder / "line.view.json");
  QTest::mouseClick(&named<QPushButton>(*panel, QStringLiteral("Take the line away")), Qt::LeftButton);
  EXPECT_FALSE(session->line.ends());
  EXPECT_EQ(seen(), without);
  window->openView(folder / "line.view.json");
  EXPECT_TRUE(session->line.ends()) << "the view file keeps it";
}

TEST_F(Watching, JointsThatSlippedAreANet) {
  solveSlide();
  auto* tabs = window->findChild<BottomPanel*>();
  auto* panel = tabs->findChild<SlippedJointsPanel*>();
  EXPECT_FALSE(session->slips.slips()) << "nobody looks";
  QTest::mouseClick(tabs->tabBar(), Qt::LeftButton, {}, tabs->tabBar()->tabRect(tabs->indexOf(panel)).center());
  ASSERT_TRUE(wait([&] { return session->slips.slips() != nullptr; }));
  ASSERT_EQ(session->slips.slips()->faces.size(), 1u);
  EXPECT_TRUE(panel->findChild<PaintingView*>()->isVisible());
  rest(100);
  keepPicture(*window, "slipped.png");
}

TEST_F(Watching, AFilmGoesAlongWithABlockAndRound) {
  solveSlide();
  window->findChild<WindowActions*>()->saveFilm->trigger();
  auto* film = window->findChild<FilmDialog*>();
  ASSERT_TRUE(film && film->isVisible());
  EXPECT_TRUE(film->options().camera.keys.empty());
  EXPECT_FALSE(film->options().camera.follow);
  const auto tick = [&](const QString& name) {
    auto& box = named<QCheckBox>(*film, name);
    QTest::mouseClick(&box, Qt::LeftButton, {}, QPoint(8, box.height() / 2));
  };
  tick(QStringLiteral("Turns about the rock by"));
  tick(QStringLiteral("Goes along with"));
  EXPECT_EQ(film->options().camera.turn, 360);
  EXPECT_EQ(named<QLineEdit>(*film, QStringLiteral("Degrees that the camera turns by")).text(),
            QString::fromUtf8("360 °"));
  EXPECT_EQ(film->options().camera.follow, 1) << "the cube: the base is fixed";
  choose(named<QComboBox>(*film, QStringLiteral("Width")), QStringLiteral("1920 pixels wide"));
  EXPECT_EQ(film->options().width, 1920);
  choose(named<QComboBox>(*film, QStringLiteral("Width")), QStringLiteral("1280 pixels wide"));
  auto* save = film->findChild<QPushButton*>(QStringLiteral("saveFilm"));
  const auto typeMoment = [&](const char* name, const char* time) {
    auto& field = named<QLineEdit>(*film, QString::fromLatin1(name));
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, QString::fromLatin1(time));
    QTest::keyClick(&field, Qt::Key_Return);
  };
  EXPECT_FALSE(film->options().from || film->options().to);
  typeMoment("Moment at which the film begins", "100 ms");
  typeMoment("Moment at which the film ends", "0.05");
  EXPECT_EQ(film->options().from, 0.1);
  EXPECT_FALSE(save->isEnabled()) << "it ends before it begins";
  typeMoment("Moment at which the film ends", "0.15");
  EXPECT_EQ(film->options().to, 0.15);
  EXPECT_TRUE(save->isEnabled());

  tick(QStringLiteral("Goes from key to key"));
  EXPECT_FALSE(save->isEnabled()) << "without keys";
  session->playback.showFrame(0);
  ASSERT_TRUE(wait([&] { return session->playback.number() == 0 && !session->playback.isWaiting(); }));
  auto& add = named<QPushButton>(*film, QStringLiteral("Add the view"));
  QTest::mouseClick(&add, Qt::LeftButton);
  window->timeline().goToLast();
  ASSERT_TRUE(wait([&] { return !session->playback.isWaiting(); }));
  window->viewport().look(View::top);
  QTest::mouseClick(&add, Qt::LeftButton);
  QTest::mouseClick(&add, Qt::LeftButton);
  ASSERT_EQ(film->options().camera.keys.size(), 2u) << "one a moment";
  EXPECT_EQ(film->options().camera.keys[0].time, 0);
  EXPECT_NEAR((film->options().camera.keys[1].position - window->viewport().pose()->position).norm(), 0, 1e-9);
  rest(100);
  keepPicture(*film, "film_dialog.png");
  ASSERT_TRUE(save->isEnabled());
  const FileAnswer answer(folder / "moved.mp4");
  QTest::mouseClick(save, Qt::LeftButton);
  ASSERT_TRUE(wait([&] { return !window->exporter().isBusy(); }));
  EXPECT_GT(std::filesystem::file_size(folder / "moved.mp4"), 2000u);

  const FileAnswer table(folder / "keys.csv");
  QTest::mouseClick(&named<QPushButton>(*film, QStringLiteral("Save as CSV…")), Qt::LeftButton);
  ASSERT_TRUE(std::filesystem::exists(folder / "keys.csv"));
  EXPECT_EQ(read_camera_keys(folder / "keys.csv").size(), 2u) << "as the command line reads them";
}

// Frames are a second of the model apart, steps two thousandths: what moves in between are moments.
TEST_F(Watching, ARunMovesInTheViewBeforeItsNextFrame) {
  QFile file(QString::fromStdString(slidingCube(4000).string()));
  ASSERT_TRUE(file.open(QIODevice::ReadWrite));
  const QByteArray text = file.readAll().replace("\"every\": 0.02", "\"every\": 1e6");
  file.resize(0);
  file.write(text);
  file.close();
  openAndMesh(folder / "cube.talus");
  session->solve();
  ASSERT_TRUE(wait([&] { return !session->run.steps().empty(); }));
  QElapsedTimer since;
  since.start();
  ASSERT_TRUE(wait([&] { return session->playback.time() > 0; }));
  EXPECT_LT(since.elapsed(), 1000) << "ms after the first step";
  EXPECT_EQ(session->playback.times().size(), 1u) << "it is no frame";
  const double first = session->playback.time();
  ASSERT_TRUE(wait([&] { return session->playback.time() > first; }));
  session->playback.showFrame(0);
  EXPECT_TRUE(wait([&] { return session->playback.time() > first; })) << "the only frame is the newest: it is followed";
  session->run.job().stop();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
}

}  // namespace
}  // namespace talus
