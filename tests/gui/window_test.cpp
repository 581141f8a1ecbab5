#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTest>
#include <QTreeWidget>

#include "driven_window.hpp"
#include "widgets/number_field.hpp"
#include "widgets/theme.hpp"

namespace talus {
namespace {

QString stripText(const QWidget& window) {
  const auto* strip = window.findChild<QWidget*>(QStringLiteral("problem-strip"));
  if (!strip->isVisible()) return {};
  QStringList texts;
  for (const auto* label : strip->findChildren<QLabel*>()) texts << label->text();
  return texts.join(u'\n');
}

TEST_F(DrivenWindow, SaysWhatIsWrongWithABrokenProject) {
  window->open(write("broken.talus", "{ \"talus\": 1, \"name\": "));
  EXPECT_FALSE(workspace->document().isOpen());
  EXPECT_TRUE(stripText(*window).contains(QStringLiteral("broken.talus"))) << stripText(*window).toStdString();

  window->open(write("poisson.talus", R"({"talus": 1, "name": "x",
    "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.5}}, "solids": []})"));
  EXPECT_TRUE(stripText(*window).contains(QStringLiteral("poisson"))) << stripText(*window).toStdString();

  window->open(folder / "is_not_there.talus");
  EXPECT_TRUE(stripText(*window).contains(QStringLiteral("is_not_there.talus"))) << stripText(*window).toStdString();

  window->open(folder);  // a folder without results
  EXPECT_EQ(workspace->problems().size(), 4u);
  EXPECT_FALSE(workspace->document().isOpen());

  window->open(sample("free_fall"));
  EXPECT_TRUE(workspace->document().isOpen());
  EXPECT_EQ(stripText(*window), QString());
}

TEST_F(DrivenWindow, SaysWhatIsWrongWithTheGeometry) {
  const auto file = write("open.talus", R"({"talus": 1, "name": "open",
    "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.25}},
    "joints": {"J1": {"friction_angle": 30}}, "default_joint": "J1",
    "solids": [{"name": "hill", "file": "hill.step", "material": "rock"}],
    "stages": [{"name": "s", "type": "dynamic", "time_step": 0.01, "steps": 2}]})");
  write("hill.step", "this is no STEP file");
  window->open(file);
  ASSERT_TRUE(workspace->document().isOpen());
  workspace->mesh();
  ASSERT_TRUE(wait([&] { return !workspace->job().isBusy(); }));
  EXPECT_EQ(workspace->system(), nullptr);
  EXPECT_TRUE(stripText(*window).contains(QStringLiteral("hill"))) << stripText(*window).toStdString();
}

TEST_F(DrivenWindow, PicksABlockIntoTheSharedSelection) {
  openAndMesh(slidingCube());
  const QPointF point = pointOnBlock();
  ASSERT_GE(point.x(), 0);
  const int block = window->viewport().pickAt(point)->block;
  auto* area = const_cast<RenderSurface&>(window->viewport().surface()).widget();
  QTest::mouseClick(area, Qt::LeftButton, {}, point.toPoint());
  EXPECT_EQ(workspace->selection().blocks(), std::vector<int>{block});
  auto* tree = window->findChild<QTreeWidget*>();
  ASSERT_NE(tree->currentItem(), nullptr);
  EXPECT_EQ(tree->currentItem()->text(0), workspace->blockName(block));
  QTest::keyClick(window.get(), Qt::Key_Escape);
  EXPECT_TRUE(workspace->selection().blocks().empty());
  EXPECT_EQ(tree->currentItem(), nullptr);
}

TEST_F(DrivenWindow, TurnsPansAndZoomsToThePointer) {
  openAndMesh(slidingCube());
  auto& view = window->viewport();
  auto* area = const_cast<RenderSurface&>(view.surface()).widget();
  const CameraPose before = *view.pose();
  QTest::mousePress(area, Qt::LeftButton, {}, {200, 200});
  QTest::mouseMove(area, {210, 200});
  QMouseEvent move(QEvent::MouseMove, QPointF(260, 220), area->mapToGlobal(QPointF(260, 220)), Qt::NoButton,
                   Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(area, &move);
  QTest::mouseRelease(area, Qt::LeftButton, {}, {260, 220});
  const CameraPose turnedPose = *view.pose();
  EXPECT_GT((turnedPose.position - before.position).norm(), 1);
  EXPECT_NEAR((turnedPose.focal_point - before.focal_point).norm(), 0, 1e-9);
  EXPECT_TRUE(workspace->selection().blocks().empty()) << "a drag is no click";

  const QPointF pointer = pointOnBlock();
  const auto under = view.pickAt(pointer);
  QWheelEvent wheel(pointer, area->mapToGlobal(pointer), {}, {0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(area, &wheel);
  const auto still = view.pickAt(pointer);
  ASSERT_TRUE(under && still);
  EXPECT_EQ(under->block, still->block);
  EXPECT_LT((view.pose()->position - view.pose()->focal_point).norm(),
            (turnedPose.position - turnedPose.focal_point).norm());
}

TEST_F(DrivenWindow, EditsAJointThroughItsFieldAndTakesItBack) {
  window->open(slidingCube());
  workspace->selection().select({Item::Kind::joint, 0});
  NumberField* field = nullptr;
  for (auto* candidate : window->findChildren<NumberField*>())
    if (candidate->accessibleName().startsWith(QStringLiteral("Friction"))) field = candidate;
  ASSERT_NE(field, nullptr);
  auto type = [&](const QString& text) {
    field->setFocus();
    rest(20);
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
  };
  type(QStringLiteral("abc"));
  EXPECT_EQ(field->property("state").toString(), QStringLiteral("error"));
  EXPECT_EQ(workspace->document().project().joints[0].friction_angle, 10);
  type(QStringLiteral("-5"));
  EXPECT_EQ(field->property("state").toString(), QStringLiteral("error"));
  EXPECT_EQ(workspace->document().project().joints[0].friction_angle, 10);
  type(QStringLiteral("22,5"));
  EXPECT_EQ(workspace->document().project().joints[0].friction_angle, 22.5);
  EXPECT_TRUE(window->windowTitle().contains(u'*'));
  workspace->document().undoStack().undo();
  EXPECT_EQ(workspace->document().project().joints[0].friction_angle, 10);
  EXPECT_FALSE(window->windowTitle().contains(u'*'));
}

TEST_F(DrivenWindow, SwitchesTheThemeWhileItRuns) {
  openAndMesh(slidingCube());
  rest(500);
  const QColor light = window->grab().toImage().pixelColor(480, 3);
  workspace->setDark(true);
  rest(500);
  const QColor dark = window->grab().toImage().pixelColor(480, 3);
  EXPECT_EQ(light, lightTokens().colours.surface);
  EXPECT_EQ(dark, darkTokens().colours.surface);
  workspace->setDark(false);
}

TEST_F(DrivenWindow, FitsItsSmallestSizeInEveryStep) {
  openAndMesh(slidingCube(40));
  workspace->solve();
  ASSERT_TRUE(wait([&] { return workspace->step() == Step::results && workspace->frame(); }));
  window->resize(1280, 720);
  for (const Step step : all_steps) {
    workspace->goTo(step);
    rest(50);
    EXPECT_EQ(window->size(), QSize(1280, 720)) << stepKey(step);  // an over-wide bar would widen it silently
    EXPECT_LE(window->minimumSizeHint().width(), 1280) << stepKey(step);
    EXPECT_LE(window->minimumSizeHint().height(), 720) << stepKey(step);
    for (const auto* button : window->findChildren<QAbstractButton*>()) {
      if (!button->isVisible() || button->text().isEmpty() || button->inherits("QCheckBox")) continue;
      EXPECT_GE(button->width(), button->minimumSizeHint().width())
          << stepKey(step) << ": " << button->text().toStdString() << " is clipped";
      const QPoint corner = button->mapTo(window.get(), QPoint(button->width(), button->height()));
      EXPECT_LE(corner.x(), 1280) << button->text().toStdString();
    }
  }
}

TEST_F(DrivenWindow, ADisabledActionSaysWhy) {
  for (const auto* action : window->actions()) {
    if (action->isEnabled() || action->toolTip().isEmpty()) continue;
    const bool undoes =
        action->text().startsWith(QStringLiteral("Undo")) || action->text().startsWith(QStringLiteral("Redo"));
    EXPECT_TRUE(undoes || action->toolTip().contains(u'\n')) << action->text().toStdString();
  }
}

}  // namespace
}  // namespace talus
