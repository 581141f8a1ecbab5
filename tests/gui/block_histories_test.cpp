#include <QComboBox>
#include <QLabel>
#include <QTabBar>

#include "driven_window.hpp"
#include "widgets/results/block_history_panel.hpp"
#include "widgets/window/bottom_panel.hpp"

namespace talus {
namespace {

TEST_F(DrivenWindow, AClickOnABlockShowsWhatBecameOfIt) {
  openAndMesh(slidingCube(100));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  auto* tabs = window->findChild<BottomPanel*>();
  auto* panel = tabs->findChild<BlockHistoryPanel*>();
  QTest::mouseClick(tabs->tabBar(), Qt::LeftButton, {}, tabs->tabBar()->tabRect(tabs->indexOf(panel)).center());
  EXPECT_TRUE(panel->findChildren<Plot*>().size() == 2 && !panel->findChild<Plot*>()->isVisible()) << "none is chosen";

  session->project.selection().select({Item::Kind::block, 1});
  ASSERT_TRUE(wait([&] { return session->histories.history() != nullptr; }));
  const QList<Plot*> plots = panel->findChildren<Plot*>();
  ASSERT_TRUE(plots[0]->isVisible());
  ASSERT_EQ(plots[0]->curves().size(), 1u);
  EXPECT_EQ(plots[0]->curves()[0].name, QStringLiteral("cube"));
  EXPECT_EQ(plots[0]->curves()[0].x, session->playback.times());
  // a = g (sin 30° − tan 10° cos 30°), from rest.
  const double a = 4.905 - 8.496 * std::tan(M_PI / 18), t = session->playback.times().back();
  EXPECT_EQ(plots[1]->unit(), QStringLiteral("m/s"));
  EXPECT_NEAR(plots[1]->curves()[0].y.back(), a * t, 0.02 * a * t);

  auto* quantity = panel->findChild<QComboBox*>();
  quantity->setFocus();
  QTest::keyClicks(quantity, "Contact");
  emit quantity->activated(quantity->currentIndex());
  EXPECT_EQ(plots[0]->unit(), QStringLiteral("kN"));
  EXPECT_NEAR(plots[0]->curves()[0].y.back(), 2.6 * 8 * 8.496 / std::cos(M_PI / 18), 4) << "N and its friction";

  session->project.selection().toggleBlock(0);
  ASSERT_TRUE(wait([&] { return session->histories.history() && session->histories.history()->blocks.size() == 2; }));
  EXPECT_EQ(plots[0]->curves().size(), 2u);
}

}  // namespace
}  // namespace talus
