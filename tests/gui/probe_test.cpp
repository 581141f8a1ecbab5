#include <QLabel>
#include <QPushButton>
#include <QTabBar>

#include "driven_window.hpp"
#include "widgets/results/line_panel.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/window/bottom_panel.hpp"

namespace talus {
namespace {

TEST_F(DrivenWindow, UnderTheMouseResultsTellBlockJointElementAndValue) {
  openAndMesh(slidingCube(100));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  SceneSettings settings = session->display.settings();
  settings.field = field_named("displacement");
  session->display.set(settings);
  rest(300);
  QWidget& view = *const_cast<RenderSurface&>(window->viewport().surface()).widget();
  const auto onCube = [&]() -> QPoint {
    for (int y = 10; y < view.height(); y += 6)
      for (int x = 10; x < view.width(); x += 6)
        if (const auto pick = window->viewport().pickAt(QPointF(x, y)); pick && pick->block == 1) return {x, y};
    return {};
  };
  QTest::mouseMove(&view, onCube());
  const auto told = [&](const QString& words) {
    for (const auto* label : window->viewport().findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(words)) return true;
    return false;
  };
  EXPECT_TRUE(wait([&] { return told(QStringLiteral("Element ")); }, 5000));
  EXPECT_TRUE(told(QStringLiteral("Face on ")));
  EXPECT_TRUE(told(QStringLiteral("Displacement ")));
}

TEST_F(DrivenWindow, TheFieldIsFollowedAlongALineThatIsClicked) {
  openAndMesh(slidingCube(100));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  auto* tabs = window->findChild<BottomPanel*>();
  auto* panel = tabs->findChild<LinePanel*>();
  tabs->setCurrentWidget(panel);
  ASSERT_TRUE(panel->isVisible());
  EXPECT_FALSE(panel->findChild<PaintingView*>()->hasPainting());
  QTest::mouseClick(panel->findChild<QPushButton*>(), Qt::LeftButton);
  ASSERT_TRUE(session->picking.isAsking());
  // Through the whole cube, along its way of a few centimetres.
  PickedPlace begin, end;
  begin.point = Vec3(0.5, 2, 2);
  end.point = Vec3(3.5, 2, 2);
  session->picking.take(begin);
  session->picking.take(end);
  ASSERT_FALSE(session->line.probe().pieces.empty());
  EXPECT_TRUE(panel->findChild<PaintingView*>()->hasPainting());
  const double way = 0.5 * (4.905 - 8.496 * std::tan(M_PI / 18)) * 0.04;  // in 0.2 s, from x = 1
  EXPECT_NEAR(session->line.probe().pieces.front().begin, 0.5 + way, 0.1 * way);
  EXPECT_NEAR(session->line.probe().pieces.back().end, 2.5 + way, 0.1 * way);
  EXPECT_NEAR(session->line.probe().pieces.back().value_at_end, way, 0.1 * way) << "the displacement";
  session->playback.showFrame(0);
  ASSERT_TRUE(wait([&] { return session->playback.frame()->index == 0; }));
  EXPECT_NEAR(session->line.probe().pieces.front().begin, 0.5, 1e-6) << "followed to another frame";
}

TEST_F(DrivenWindow, APointOfABlockThatHasMovedIsWhereItIsNow) {
  openAndMesh(slidingCube(100));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  rest(300);
  const auto pick = window->viewport().pickAt(pointOnBlock());
  ASSERT_TRUE(pick);
  const PickedPlace place = window->viewport().placeOf(*pick);
  EXPECT_NEAR((place.seen() - pick->position).norm(), 0, 1e-4) << "drawn at its true displacement";
}

}  // namespace
}  // namespace talus
