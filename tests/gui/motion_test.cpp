#include <QLabel>

#include "driven_window.hpp"
#include "widgets/project/page_table.hpp"
#include "widgets/setup/property_panel.hpp"

namespace talus {
namespace {

constexpr char sliding[] = "sliding on J1 (base)";

TEST_F(DrivenWindow, TheTableAndThePropertiesSayHowABlockMovesInTheFrameInView) {
  openAndMesh(slidingCube(100));
  session->project.selection().select({Item::Kind::block, 1});
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  session->playback.showFrame(10);
  ASSERT_TRUE(wait([&] { return session->playback.frame()->index == 10; }));

  auto* table = window->findChild<PageTable*>();
  ASSERT_EQ(table->rowCount(), 1);  // the base is fixed
  EXPECT_EQ(table->item(0, 0)->text(), QStringLiteral("cube"));
  EXPECT_EQ(table->item(0, 1)->text(), QString::fromUtf8(sliding));
  EXPECT_EQ(table->item(0, 2)->text(), QStringLiteral("090°/0°"));

  const auto told = [&](const QString& words) {
    for (const auto* label : window->findChild<PropertyPanel*>()->findChildren<QLabel*>())
      if (label->text() == words) return true;
    return false;
  };
  EXPECT_TRUE(told(QString::fromUtf8(sliding) + QStringLiteral(", to 090°/0°")));
  session->playback.showFrame(0);
  ASSERT_TRUE(wait([&] { return session->playback.frame()->index == 0; }));
  EXPECT_TRUE(told(QStringLiteral("stable")));
}

}  // namespace
}  // namespace talus
