#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTest>
#include <QTreeWidget>

#include "driven_window.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/view/render_surface.hpp"

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
  EXPECT_FALSE(session->project.document().isOpen());
  EXPECT_TRUE(stripText(*window).contains(QStringLiteral("broken.talus"))) << stripText(*window).toStdString();

  window->open(write("poisson.talus", R"({"talus": 1, "name": "x",
    "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.5}}, "solids": []})"));
  EXPECT_TRUE(stripText(*window).contains(QStringLiteral("poisson"))) << stripText(*window).toStdString();

  window->open(folder / "is_not_there.talus");
  EXPECT_TRUE(stripText(*window).contains(QStringLiteral("is_not_there.talus"))) << stripText(*window).toStdString();

  window->open(folder);  // a folder without results
  EXPECT_EQ(session->messages.problems().size(), 4u);
  EXPECT_FALSE(session->project.document().isOpen());

  window->open(sample("free_fall"));
  EXPECT_TRUE(session->project.document().isOpen());
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
  ASSERT_TRUE(session->project.document().isOpen());
  session->run.mesh();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
  EXPECT_EQ(session->project.system(), nullptr);
  EXPECT_TRUE(stripText(*window).contains(QStringLiteral("hill"))) << stripText(*window).toStdString();
}

TEST_F(DrivenWindow, PicksABlockIntoTheSharedSelection) {
  openAndMesh(slidingCube());
  const QPointF point = pointOnBlock();
  ASSERT_GE(point.x(), 0);
  const int block = window->viewport().pickAt(point)->block;
  auto* area = const_cast<RenderSurface&>(window->viewport().surface()).widget();
  QTest::mouseClick(area, Qt::LeftButton, {}, point.toPoint());
  EXPECT_EQ(session->project.selection().blocks(), std::vector<int>{block});
  auto* tree = window->findChild<QTreeWidget*>();
  ASSERT_NE(tree->currentItem(), nullptr);
  EXPECT_EQ(tree->currentItem()->text(0), session->project.blockName(block));
  QTest::keyClick(window.get(), Qt::Key_Escape);
  EXPECT_TRUE(session->project.selection().blocks().empty());
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
  EXPECT_TRUE(session->project.selection().blocks().empty()) << "a drag is no click";

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
  session->project.selection().select({Item::Kind::joint, 0});
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
  EXPECT_EQ(session->project.document().project().joints[0].friction_angle, 10);
  type(QStringLiteral("-5"));
  EXPECT_EQ(field->property("state").toString(), QStringLiteral("error"));
  EXPECT_EQ(session->project.document().project().joints[0].friction_angle, 10);
  type(QStringLiteral("22,5"));
  EXPECT_EQ(session->project.document().project().joints[0].friction_angle, 22.5);
  EXPECT_TRUE(window->windowTitle().contains(u'*'));
  session->project.document().undoStack().undo();
  EXPECT_EQ(session->project.document().project().joints[0].friction_angle, 10);
  EXPECT_FALSE(window->windowTitle().contains(u'*'));
}

TEST_F(DrivenWindow, SwitchesTheThemeWhileItRuns) {
  openAndMesh(slidingCube());
  rest(500);
  const QColor light = window->grab().toImage().pixelColor(480, 3);
  session->display.setDark(true);
  rest(500);
  const QColor dark = window->grab().toImage().pixelColor(480, 3);
  EXPECT_EQ(light, lightTokens().colours.surface);
  EXPECT_EQ(dark, darkTokens().colours.surface);
  session->display.setDark(false);
}

TEST_F(DrivenWindow, FitsItsSmallestSizeInEveryStep) {
  openAndMesh(slidingCube(40));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  window->resize(1280, 720);
  for (const WorkflowPage step : all_pages) {
    session->display.goTo(step);
    rest(50);
    EXPECT_EQ(window->size(), QSize(1280, 720)) << pageKey(step);  // an over-wide bar would widen it silently
    EXPECT_LE(window->minimumSizeHint().width(), 1280) << pageKey(step);
    EXPECT_LE(window->minimumSizeHint().height(), 720) << pageKey(step);
    for (const auto* button : window->findChildren<QAbstractButton*>()) {
      if (!button->isVisible() || button->text().isEmpty() || button->inherits("QCheckBox")) continue;
      EXPECT_GE(button->width(), button->minimumSizeHint().width())
          << pageKey(step) << ": " << button->text().toStdString() << " is clipped";
      const QPoint corner = button->mapTo(window.get(), QPoint(button->width(), button->height()));
      EXPECT_LE(corner.x(), 1280) << button->text().toStdString();
    }
  }
}

/// Why the actions of this name cannot be used, as their tooltips say; empty for one that can be.
QStringList whyNot(const QWidget& window, const char* name) {
  QStringList reasons;
  for (const auto* action : window.actions())
    if (action->text() == QString::fromUtf8(name))
      reasons << (action->isEnabled() ? QString() : action->toolTip().section(u'\n', 1));
  return reasons;
}

TEST_F(DrivenWindow, ADisabledActionSaysWhy) {
  const QStringList noProject{QStringLiteral("Open a project first")};
  const QString usable;
  for (const char* name : {"Save", "Save as…", "Cut and mesh", "Solve", "Geometry", "Solve page", "Results"})
    EXPECT_EQ(whyNot(*window, name), noProject) << name;
  EXPECT_EQ(whyNot(*window, "Save film…"), QStringList(QStringLiteral("Nothing has been solved yet")));
  EXPECT_EQ(whyNot(*window, "Fit all"), QStringList(QStringLiteral("There is no rock yet")));
  EXPECT_EQ(whyNot(*window, "Stop"), QStringList(QStringLiteral("Nothing runs")));
  EXPECT_EQ(whyNot(*window, "Open…"), QStringList(usable));
  int disabled = 0;
  for (const auto* action : window->actions()) {
    if (action->isEnabled() || action->text().startsWith(QStringLiteral("Undo")) ||
        action->text().startsWith(QStringLiteral("Redo")))
      continue;
    ++disabled;
    EXPECT_FALSE(action->toolTip().section(u'\n', 1).isEmpty()) << action->text().toStdString();
  }
  EXPECT_GT(disabled, 25);

  window->open(slidingCube(40));
  EXPECT_TRUE(wait([&] { return whyNot(*window, "Cut and mesh") == QStringList(usable); }));
  EXPECT_EQ(whyNot(*window, "Save"), QStringList(QStringLiteral("Nothing has changed since it was saved")));
  session->run.mesh();
  EXPECT_EQ(whyNot(*window, "Cut and mesh"), QStringList(QStringLiteral("A run goes on")));
  EXPECT_EQ(whyNot(*window, "Open…"), QStringList(QStringLiteral("A run goes on: stop it first")));
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
  EXPECT_EQ(whyNot(*window, "Fit all"), QStringList(usable));
  EXPECT_EQ(whyNot(*window, "Hide what is selected"), QStringList(QStringLiteral("Select a block or a solid first")));
  session->project.selection().select({Item::Kind::block, 0});
  EXPECT_EQ(whyNot(*window, "Hide what is selected"), QStringList(usable));
}

}  // namespace
}  // namespace talus
