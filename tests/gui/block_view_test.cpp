// Which blocks are seen, and what is picked on them: hidden, shown alone, clicked, refined near a face.
#include <gmock/gmock.h>

#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <set>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "widgets/view/render_surface.hpp"

namespace talus {
namespace {

using testing::ElementsAre;

class BlockView : public DrivenWindow {
 protected:
  void SetUp() override {
    DrivenWindow::SetUp();
    openAndMesh(slidingCube(40));
    session->display.goTo(WorkflowPage::blocks);
    rest(50);
  }
  const Project& project() { return session->project.document().project(); }
  QWidget& area() { return *const_cast<RenderSurface&>(window->viewport().surface()).widget(); }
  void press(Qt::Key key) {
    area().setFocus();
    QTest::keyClick(&area(), key);
    rest(50);
  }
  /// The blocks that are met under some pixel.
  std::set<int> seen() {
    std::set<int> blocks;
    const Viewport& view = window->viewport();
    for (int y = 4; y < view.height(); y += 4)
      for (int x = 4; x < view.width(); x += 4)
        if (const auto pick = view.pickAt(QPointF(x, y))) blocks.insert(pick->block);
    return blocks;
  }
  QPoint pointOn(int block) {
    const Viewport& view = window->viewport();
    for (int y = 4; y < view.height(); y += 4)
      for (int x = 4; x < view.width(); x += 4)
        if (const auto pick = view.pickAt(QPointF(x, y)); pick && pick->block == block) return {x, y};
    ADD_FAILURE() << "block " << block << " is not seen";
    return {};
  }
};

TEST_F(BlockView, BlocksAreHiddenShownAloneAndShownAgain) {
  ASSERT_THAT(seen(), ElementsAre(0, 1));
  session->project.selection().selectBlocks({1});
  press(Qt::Key_H);
  EXPECT_THAT(seen(), ElementsAre(0)) << "H hides what is selected";
  press(Qt::Key_A);
  EXPECT_THAT(seen(), ElementsAre(0, 1)) << "A shows all";
  session->project.selection().selectBlocks({1});
  press(Qt::Key_I);
  EXPECT_THAT(seen(), ElementsAre(1)) << "I shows it alone";
  session->display.goTo(WorkflowPage::mesh);
  rest(50);
  EXPECT_THAT(seen(), ElementsAre(1)) << "on other pages, too";
  press(Qt::Key_A);
  EXPECT_THAT(seen(), ElementsAre(0, 1));
}

TEST_F(BlockView, AClickSelectsAndWithControlAddsAndTakesOut) {
  QTest::mouseClick(&area(), Qt::LeftButton, {}, pointOn(0));
  rest(30);
  EXPECT_THAT(session->project.selection().blocks(), ElementsAre(0));
  QTest::mouseClick(&area(), Qt::LeftButton, Qt::ControlModifier, pointOn(1));
  rest(30);
  EXPECT_THAT(session->project.selection().blocks(), ElementsAre(0, 1));
  QTest::mouseClick(&area(), Qt::LeftButton, Qt::ControlModifier, pointOn(0));
  rest(30);
  EXPECT_THAT(session->project.selection().blocks(), ElementsAre(1));
}

TEST_F(BlockView, TheMeshIsRefinedNearAFaceThatIsClicked) {
  const std::size_t coarse = session->project.system()->blocks[1].mesh.tetrahedra.size();
  session->display.goTo(WorkflowPage::mesh);
  rest(30);
  auto* refine = window->findChild<QToolButton*>(QStringLiteral("refine face"));
  ASSERT_TRUE(refine && refine->isVisible());
  QTest::mouseClick(refine, Qt::LeftButton);
  ASSERT_TRUE(session->picking.isAsking());
  session->picking.take({.block = 1, .solid = 1, .joint = -1, .point = {1.5, 2.5, 3}, .normal = {0, 0, 1}});
  ASSERT_EQ(project().mesh.refinements.size(), 1U);
  const std::vector<Vec3>& face = project().mesh.refinements[0].face;
  ASSERT_EQ(face.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(face[i].z(), 3) << "the top of the cube";
    EXPECT_EQ((face[(i + 1) % 4] - face[i]).norm(), 2) << "corner after corner";
  }
  EXPECT_EQ(session->project.document().undoStack().undoText(), QStringLiteral("refine the mesh near a face"));
  EXPECT_TRUE(window->findChild<QLabel*>(QStringLiteral("ahead"))->text().startsWith(QStringLiteral("Meshed anew")));
  rest(300);
  keepPicture(*window, "refined_face.png");
  session->run.mesh();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
  EXPECT_GT(session->project.system()->blocks[1].mesh.tetrahedra.size(), 2 * coarse);
  session->project.document().undoStack().undo();
  EXPECT_TRUE(project().mesh.refinements.empty());
}

}  // namespace
}  // namespace talus
