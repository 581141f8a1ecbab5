#include "widgets/results/slide_panel.hpp"

#include <QTabBar>

#include "driven_window.hpp"
#include "widgets/window/bottom_panel.hpp"

namespace talus {
namespace {

/// What the panel's table says of something; empty where it says nothing.
QString said(const SlidePanel& panel, const QString& of) {
  const auto* table = panel.findChild<PlainTable*>();
  for (int row = 0; row < table->rowCount(); ++row)
    if (table->item(row, 0)->text() == of) return table->item(row, 1)->text();
  return {};
}

TEST_F(DrivenWindow, RunOutIsMeasuredWhenItsTabIsLookedAt) {
  openAndMesh(slidingCube(100));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  auto* tabs = window->findChild<BottomPanel*>();
  auto* panel = tabs->findChild<SlidePanel*>();
  EXPECT_FALSE(session->slide.slide()) << "nobody looks";
  const int tab = tabs->indexOf(panel);
  QTest::mouseClick(tabs->tabBar(), Qt::LeftButton, {}, tabs->tabBar()->tabRect(tab).center());
  ASSERT_TRUE(wait([&] { return session->slide.slide() != nullptr; }));
  EXPECT_EQ(said(*panel, "Blocks that moved"), QStringLiteral("0 of 1")) << "7 cm of 40 m";
  EXPECT_FALSE(panel->findChild<PaintingView*>()->isVisible());

  auto* length = panel->findChild<NumberField*>();
  length->setFocus();
  length->selectAll();
  QTest::keyClicks(length, "1 cm");
  QTest::keyClick(length, Qt::Key_Return);
  ASSERT_TRUE(wait([&] { return session->slide.slide() && !session->slide.slide()->run_out.rock.blocks.empty(); }));
  EXPECT_EQ(said(*panel, "Blocks that moved"), QStringLiteral("1 of 1"));
  EXPECT_EQ(said(*panel, "Forward"), QString::fromUtf8("090°"));
  EXPECT_FALSE(said(*panel, "Travel angle, crown to toe").isEmpty());
  EXPECT_TRUE(panel->findChild<PaintingView*>()->isVisible());
  auto* front = panel->findChild<Plot*>();
  ASSERT_EQ(front->curves().size(), 1u);
  EXPECT_EQ(front->curves()[0].x.size(), session->playback.times().size());
}

}  // namespace
}  // namespace talus
