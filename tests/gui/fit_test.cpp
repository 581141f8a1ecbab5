// The camera keeps all that there is in view, beside the tools, until the user moves it.
#include <QAction>
#include <QApplication>
#include <QMouseEvent>
#include <QTest>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "widgets/view/render_surface.hpp"

namespace talus {
namespace {

class FittedView : public DrivenWindow {
 protected:
  void SetUp() override {
    DrivenWindow::SetUp();
    openAndMesh(slidingCube(40));
    rest(50);
  }
  Viewport& view() { return window->viewport(); }
  /// Around all of the rock that is drawn, in the view.
  QRectF rock() {
    view().picture();  // drawn as it is now
    double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
    for (const Block& block : view().shown()->blocks)
      for (const Vec3& node : block.mesh.nodes) {
        const auto point = view().pointOf(node);
        if (!point) continue;
        left = std::min(left, point->x()), right = std::max(right, point->x());
        top = std::min(top, point->y()), bottom = std::max(bottom, point->y());
      }
    return {QPointF(left, top), QPointF(right, bottom)};
  }
  void expectFitted(const char* where, double used = 0.7) {
    const QRectF seen = rock();
    const double free = view().tools()->x();
    EXPECT_GE(seen.left(), 0) << where;
    EXPECT_GE(seen.top(), 0) << where;
    EXPECT_LE(seen.right(), free - 4) << where << ": not even at their edge";
    EXPECT_LE(seen.bottom(), view().height()) << where;
    EXPECT_GT(std::max(seen.width() / free, seen.height() / view().height()), used) << where << ": the room is used";
  }
  void trigger(const char* words) {
    for (auto* action : window->actions())
      if (action->text() == QString::fromUtf8(words)) return action->trigger();
    FAIL() << words;
  }
};

TEST_F(FittedView, FillsWhatTheToolsLeaveWhateverTheWindowsSize) {
  expectFitted("as it opened");
  window->resize(1600, 1000);
  rest(50);
  expectFitted("a larger window");
  trigger("The view alone");
  rest(50);
  expectFitted("the view alone");
}

/// A legend takes room beside the rock: what was fitted without it would be moved under the tools.
TEST_F(FittedView, MakesRoomForALegendThatComesWithResults) {
  session->solve();
  ASSERT_TRUE(
      wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }, 20000));
  rest(50);
  const auto withLegend = [&](bool shown) {
    SceneSettings settings = session->display.settings();
    settings.legend = shown;
    session->display.set(settings);
    rest(50);
    shown ? expectFitted("beside the legend", 0.6) : expectFitted("without it");
    return rock();
  };
  const QRectF with = withLegend(true), without = withLegend(false);
  EXPECT_GT(with.left(), without.left() + 20);
  EXPECT_NEAR(withLegend(true).left(), with.left(), 1);
}

/// An arrow has its length on the screen, and would reach out of a view that just holds the rock.
TEST_F(FittedView, TakesInWhatActsOnThePageThatShowsIt) {
  Project changed = session->project.document().project();
  changed.loads = {{.block = "cube", .at = {2, 2, 3}, .force = Vec3(0, 0, -1e6), .table = {}}};
  session->project.document().change(changed, QStringLiteral("act"));
  ASSERT_TRUE(session->project.system() != nullptr) << "a load cuts nothing";
  session->display.goTo(WorkflowPage::blocks);
  rest(50);
  const double alone = rock().height();
  session->display.goTo(WorkflowPage::loads);
  rest(50);
  EXPECT_LT(rock().height(), alone);
  session->display.goTo(WorkflowPage::blocks);
  rest(50);
  EXPECT_NEAR(rock().height(), alone, 1);
}

TEST_F(FittedView, StaysWhereTheUserHasTurnedIt) {
  QWidget* surface = const_cast<RenderSurface&>(view().surface()).widget();
  QTest::mousePress(surface, Qt::LeftButton, {}, QPoint(100, 100));
  QMouseEvent move(QEvent::MouseMove, QPointF(140, 110), surface->mapToGlobal(QPointF(140, 110)), Qt::NoButton,
                   Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(surface, &move);
  QTest::mouseRelease(surface, Qt::LeftButton, {}, QPoint(140, 110));
  rest(50);
  const Vec3 turned = view().pose()->position;
  session->display.goTo(WorkflowPage::loads);
  window->resize(1500, 900);
  rest(50);
  rock();
  EXPECT_TRUE(view().pose()->position.isApprox(turned));
}

}  // namespace
}  // namespace talus
