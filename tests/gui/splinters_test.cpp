// Splinters that cuts leave: they are told, shown, and done away with.
#include <gmock/gmock.h>

#include <QTest>

#include "driven_window.hpp"
#include "example_projects.hpp"
#include "listed_runs.hpp"
#include "mesh/volume_sum.hpp"
#include "widgets/blocks/splinter_panel.hpp"
#include "widgets/kit/plain_table.hpp"
#include "widgets/window/bottom_panel.hpp"

namespace talus {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

class SplintersWindow : public DrivenWindow {
 protected:
  /// The two cuts take 0.1 mm off the upper edges of a cube of 10 m.
  void open() {
    window->open(write("cube.talus", example::splinters));
    ASSERT_TRUE(session->project.document().isOpen());
    session->display.goTo(WorkflowPage::blocks);
  }
  void cut() {
    session->run.mesh();
    ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
    rest(50);
  }
  SplinterPanel& panel() { return *window->findChild<SplinterPanel*>(); }
  PlainTable& table() { return *window->findChild<PlainTable*>(QStringLiteral("splinters")); }
  bool hasTab() { return window->findChild<BottomPanel*>()->indexOf(&panel()) >= 0; }
  const Project& project() { return session->project.document().project(); }
};

TEST_F(SplintersWindow, AreToldAndShownWhereTheyKeepTheRockFromBeingCut) {
  open();
  EXPECT_FALSE(hasTab());
  cut();
  EXPECT_EQ(session->project.system(), nullptr);
  EXPECT_EQ(window->findChild<BottomPanel*>()->currentWidget(), &panel());
  EXPECT_EQ(table().rowCount(), 2);
  EXPECT_EQ(table().item(0, 1)->text(), QStringLiteral("refused"));
  EXPECT_THAT(session->messages.problems().back().problem.toStdString(),
              testing::StartsWith("the cuts leave 2 splinters, the thinnest "));
  EXPECT_THAT(session->display.settings().places, SizeIs(2));
  EXPECT_NEAR(session->display.settings().places[0].at.z(), 10, 1e-3);
  keepPicture(*window, "splinters.png");
}

TEST_F(SplintersWindow, LeadToTheJointBesideThem) {
  open();
  cut();
  for (int row = 0; row < 2; ++row) {
    const bool isWest = table().item(row, 4)->text().toDouble() < 5;  // E
    table().setCurrentCell(row, 0);
    click(button(panel(), "Move the joint"));
    EXPECT_EQ(session->display.page(), WorkflowPage::joints);
    EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::cut, isWest ? 1 : 0}));
  }
}

TEST_F(SplintersWindow, AreDroppedOrMergedByAButtonAndTold) {
  open();
  cut();
  click(button(panel(), "Drop them"));
  EXPECT_EQ(project().splinters.rule, SplinterRule::drop);
  EXPECT_EQ(session->project.document().undoStack().undoText(), QStringLiteral("leave splinters out"));
  cut();
  ASSERT_NE(session->project.system(), nullptr);
  EXPECT_EQ(session->project.system()->blocks.size(), 1u);
  EXPECT_TRUE(hasTab());
  EXPECT_EQ(table().item(0, 1)->text(), QStringLiteral("left out"));
  EXPECT_TRUE(volume_sum(*session->project.system()).adds_up());
  click(button(panel(), "Merge with neighbours"));
  cut();
  EXPECT_EQ(table().item(0, 1)->text(), QStringLiteral("part of cube.2"));
  EXPECT_EQ(window->findChild<BottomPanel*>()->currentIndex(), 0) << "the blocks, while there were no splinters";
  session->project.document().undoStack().undo();
  session->project.document().undoStack().undo();
  EXPECT_EQ(project().splinters.rule, SplinterRule::refuse);
}

TEST_F(SplintersWindow, AreForgottenWithTheirProject) {
  open();
  cut();
  ASSERT_TRUE(hasTab());
  window->open(slidingCube());
  EXPECT_FALSE(hasTab());
  EXPECT_THAT(session->display.settings().places, IsEmpty());
}

}  // namespace
}  // namespace talus
