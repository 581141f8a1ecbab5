#include <QLabel>
#include <QTest>

#include "driven_window.hpp"
#include "listed_runs.hpp"

namespace talus {
namespace {

/// A cube on a base, both cut, and someone who asks for places.
class PickingWindow : public DrivenWindow {
 protected:
  void SetUp() override {
    DrivenWindow::SetUp();
    openAndMesh(slidingCube(40));
  }
  void ask(int count) {
    session->picking.ask(QStringLiteral("Click a corner"), count,
                         [this](const std::vector<PickedPlace>& places) { picked = places; });
    rest(20);
  }
  QWidget& area() { return *window->viewport().findChild<QWidget*>(QStringLiteral("view area")); }
  QWidget& strip() { return *window->viewport().findChild<QWidget*>(QStringLiteral("picking")); }
  std::string said() {
    std::string words;
    for (auto* label : strip().findChildren<QLabel*>()) words += label->text().toStdString() + "|";
    return words;
  }
  void clickAt(QPointF point) {
    QTest::mouseClick(&area(), Qt::LeftButton, {}, point.toPoint());
    rest(20);
  }
  /// A point of the view where this block lies.
  QPointF pointOn(int block) {
    const Viewport& view = window->viewport();
    for (int y = 20; y < view.height(); y += 10)
      for (int x = 20; x < view.width(); x += 10)
        if (const auto pick = view.pickAt(QPointF(x, y)); pick && pick->block == block) return QPointF(x, y);
    ADD_FAILURE() << "block " << block << " is not in view";
    return {-1, -1};
  }
  /// The point lies on the cube [1, 3]³ and the normal leaves it there.
  static void expectOnCube(const PickedPlace& place) {
    int axis = 0;
    EXPECT_NEAR(place.normal.cwiseAbs().maxCoeff(&axis), 1, 1e-9);
    EXPECT_NEAR(place.point[axis], place.normal[axis] > 0 ? 3 : 1, 1e-9);
    for (int i = 0; i < 3; ++i) {
      EXPECT_GE(place.point[i], 1 - 1e-9);
      EXPECT_LE(place.point[i], 3 + 1e-9);
    }
  }

  std::vector<PickedPlace> picked;
};

TEST_F(PickingWindow, ClicksGivePlacesOnTheRock) {
  EXPECT_FALSE(strip().isVisible());
  ask(2);
  EXPECT_TRUE(strip().isVisible());
  EXPECT_NE(said().find("1 of 2: Click a corner"), std::string::npos) << said();
  EXPECT_EQ(area().cursor().shape(), Qt::CrossCursor);
  clickAt(pointOn(1));
  ASSERT_EQ(session->picking.soFar().size(), 1u);
  EXPECT_NE(said().find("2 of 2"), std::string::npos) << said();
  EXPECT_TRUE(session->project.selection().blocks().empty()) << "a click that was asked for selects nothing";
  rest(80);
  keepPicture(window->viewport(), "picking.png");
  clickAt(pointOn(1) + QPointF(10, 10));
  ASSERT_EQ(picked.size(), 2u);
  for (const PickedPlace& place : picked) {
    EXPECT_EQ(place.block, 1);
    EXPECT_EQ(place.solid, 1);
    EXPECT_EQ(place.joint, -1);
    expectOnCube(place);
  }
  EXPECT_FALSE(strip().isVisible());
  EXPECT_EQ(area().cursor().shape(), Qt::ArrowCursor);
}

TEST_F(PickingWindow, TheCameraTurnsWhileItAsksAndAClickBesideTheRockIsNone) {
  ask(1);
  const CameraPose before = *window->viewport().pose();
  const QPointF from = pointOn(1);
  QTest::mousePress(&area(), Qt::LeftButton, {}, from.toPoint());
  for (int i = 1; i <= 4; ++i) {
    const QPointF at = from + QPointF(10 * i, 0);
    QMouseEvent move(QEvent::MouseMove, at, area().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&area(), &move);
  }
  QTest::mouseRelease(&area(), Qt::LeftButton, {}, (from + QPointF(40, 0)).toPoint());
  EXPECT_GT((window->viewport().pose()->position - before.position).norm(), 0.1);
  clickAt({4, window->viewport().height() - 4.0});
  EXPECT_TRUE(session->picking.isAsking());
  EXPECT_TRUE(picked.empty());
}

TEST_F(PickingWindow, EscapeEndsItAndKeepsTheSelection) {
  session->project.selection().select({Item::Kind::block, 1});
  ask(3);
  QTest::keyClick(window.get(), Qt::Key_Escape);
  EXPECT_FALSE(session->picking.isAsking());
  EXPECT_FALSE(strip().isVisible());
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::block, 1}));
  ask(1);
  window->open(slidingCube());
  EXPECT_FALSE(session->picking.isAsking()) << "of a project that is gone";
}

TEST_F(PickingWindow, PlacesAreThoseOfTheRockAtRest) {
  session->solve();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy() && session->playback.frame(); }));
  ASSERT_TRUE(wait([&] { return !session->playback.isLoading() && !session->playback.isWaiting(); }));
  SceneSettings settings = session->display.settings();
  settings.deformation_scale = 100;
  session->display.set(settings);
  session->playback.showFrame(static_cast<int>(session->playback.times().size()) - 1);
  ASSERT_TRUE(wait([&] { return !session->playback.isWaiting(); }));
  window->viewport().fit();
  rest(50);
  ask(1);
  const QPointF at = pointOn(1);
  const auto pick = window->viewport().pickAt(at);
  EXPECT_GT((pick->position - pick->rest).norm(), 0.5) << "it is drawn elsewhere";
  clickAt(at);
  ASSERT_EQ(picked.size(), 1u);
  expectOnCube(picked[0]);
  EXPECT_LT((*window->viewport().pointOf(picked[0]) - at).manhattanLength(), 2);
}

}  // namespace
}  // namespace talus
