// The stages as a strip in time: a click selects, edges and boxes are dragged.
#include <QTest>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "widgets/actions/stage_strip.hpp"

namespace talus {
namespace {

class Stages : public DrivenWindow {
 protected:
  void SetUp() override {
    DrivenWindow::SetUp();
    window->open(slidingCube(40));
    Project changed = session->project.document().project();
    Stage settle{.name = "settle", .kind = StageKind::static_, .time_step = 0.1, .steps = {}, .duration = 2.0};
    settle.until_equilibrium = true;
    Stage slide{.name = "slide", .time_step = 0.01, .steps = 400, .duration = {}};
    slide.joints = {
        {.name = "J1", .friction_angle = 20, .residual_friction_angle = {}, .cohesion = 0.0, .tensile_strength = {}}};
    Stage rest_stage{.name = "come to rest", .time_step = 0.02, .steps = {}, .duration = 1.0};
    rest_stage.loads = std::vector<PointLoad>{};
    rest_stage.damping = 0.5;
    changed.stages = {settle, slide, rest_stage};
    session->project.document().change(changed, QStringLiteral("stages"));
    session->display.goTo(WorkflowPage::stages);
    rest(50);
  }
  StageStrip& strip() { return *window->findChild<StageStrip*>(); }
  const std::vector<Stage>& stages() { return session->project.document().project().stages; }
  int steps() { return session->project.document().undoStack().count(); }
};

TEST_F(Stages, AClickSelectsAndWordsSayWhatChanges) {
  QTest::mouseClick(&strip(), Qt::LeftButton, {}, strip().boxOf(1).center().toPoint());
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::stage, 1}));
  const QString words = strip().accessibleDescription();
  EXPECT_TRUE(words.contains(QStringLiteral("slide: dynamic, 4 s; changes J1 φ 20°, c 0 MPa"))) << words.toStdString();
  EXPECT_TRUE(words.contains(QStringLiteral("settle: static, at most 2 s; changes nothing"))) << words.toStdString();
  keepPicture(*window, "stages.png");
}

TEST_F(Stages, TheRightEdgeIsDraggedToAnotherLengthInOneStep) {
  const int before = steps();
  const QRectF box = strip().boxOf(1);
  drag(strip(), {box.right(), box.center().y()}, box.center());
  EXPECT_EQ(steps(), before + 1);
  EXPECT_NEAR(*stages()[1].steps, 200, 4) << "half as long, in steps as it was said";
  EXPECT_EQ(stages()[1].time_step, 0.01);
  const QRectF last = strip().boxOf(2);
  drag(strip(), {last.right() - 2, last.center().y()}, last.center());
  EXPECT_NEAR(*stages()[2].duration, 0.5, 0.03);
  const double whole = *stages()[2].duration / 0.02;
  EXPECT_NEAR(whole, std::round(whole), 1e-6) << "in whole time steps";
}

TEST_F(Stages, AStageIsDraggedToAnotherPlaceInTheOrder) {
  const int before = steps();
  drag(strip(), strip().boxOf(0).center(), strip().boxOf(2).center() + QPointF(10, 0));
  EXPECT_EQ(steps(), before + 1);
  EXPECT_EQ(stages()[2].name, "settle");
  EXPECT_EQ(stages()[0].name, "slide");
  session->project.document().undoStack().undo();
  EXPECT_EQ(stages()[0].name, "settle");
}

TEST_F(Stages, TheKeyboardDoesTheSame) {
  strip().setFocus();
  QTest::keyClick(&strip(), Qt::Key_Right);
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::stage, 0}));
  QTest::keyClick(&strip(), Qt::Key_Right);
  QTest::keyClick(&strip(), Qt::Key_Right, Qt::ControlModifier);
  EXPECT_EQ(*stages()[1].steps, 401);
  QTest::keyClick(&strip(), Qt::Key_Left, Qt::AltModifier);
  EXPECT_EQ(stages()[0].name, "slide");
}

TEST_F(Stages, TheStripIsThereOnItsPageAlone) {
  EXPECT_TRUE(strip().isVisible());
  session->display.goTo(WorkflowPage::loads);
  EXPECT_FALSE(strip().isVisible());
}

}  // namespace
}  // namespace talus
