// Loads, supports, velocities and monitors made by pointing at the rock, and their glyphs in the view.
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>
#include <map>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "widgets/actions/load_actions.hpp"
#include "widgets/actions/vector_dialog.hpp"
#include "widgets/project/page_table.hpp"
#include "widgets/view/render_surface.hpp"

namespace talus {
namespace {

class Loads : public DrivenWindow {
 protected:
  void SetUp() override {
    DrivenWindow::SetUp();
    openAndMesh(slidingCube(40));
    session->display.goTo(WorkflowPage::loads);
    rest(20);
  }
  const Project& project() { return session->project.document().project(); }
  QString undoText() { return session->project.document().undoStack().undoText(); }
  /// By its words, as the menus have it.
  void trigger(const char* words) {
    for (auto* action : window->actions())
      if (action->text() == QString::fromUtf8(words)) return action->trigger();
    FAIL() << words;
  }
  /// As a click in the view does it: on the top of the cube.
  void pickTop() {
    ASSERT_TRUE(session->picking.isAsking());
    session->picking.take({.block = 1, .solid = 1, .joint = -1, .point = {1.5, 2.5, 3}, .normal = {0, 0, 1}});
    rest(20);
  }
  void type(const char* name, const char* words) {
    auto* field = window->findChild<QLineEdit*>(QLatin1String(name));
    ASSERT_NE(field, nullptr) << name;
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QString::fromUtf8(words));
    QTest::keyClick(field, Qt::Key_Tab);
  }
  void create() {
    auto* button = window->findChild<QPushButton*>(QStringLiteral("vector#create"));
    ASSERT_NE(button, nullptr);
    click(*button);
    rest(20);
  }
};

TEST_F(Loads, ALoadAtAPointIsAskedForAndMadeInOneStep) {
  trigger("Load at a point…");
  EXPECT_TRUE(session->picking.prompt().contains(QStringLiteral("point")));
  pickTop();
  auto* dialog = window->findChild<VectorDialog*>();
  ASSERT_NE(dialog, nullptr);
  type("vector#amount", "0.25 MN");
  keepPicture(*dialog, "new_load.png");
  create();
  ASSERT_EQ(project().loads.size(), 1u);
  EXPECT_EQ(project().loads[0].block, "cube");
  EXPECT_EQ(project().loads[0].at, Vec3(1.5, 2.5, 3));
  EXPECT_EQ(project().loads[0].force, Vec3(0, 0, -250e3));
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::load, 0}));
  EXPECT_EQ(undoText(), QStringLiteral("add a load on cube"));
  session->project.document().undoStack().undo();
  EXPECT_TRUE(project().loads.empty());
}

TEST_F(Loads, APressureOnAFaceBecomesItsResultantAtTheCentroid) {
  trigger("Load on a face…");
  pickTop();
  auto* as = window->findChild<QComboBox*>(QStringLiteral("vector#as"));
  ASSERT_NE(as, nullptr);
  as->setCurrentIndex(1);
  type("vector#pressure", "50");  // kPa, on 2 × 2 m
  create();
  ASSERT_EQ(project().loads.size(), 1u);
  EXPECT_NEAR((project().loads[0].at - Vec3(2, 2, 3)).norm(), 0, 1e-6);
  EXPECT_NEAR((project().loads[0].force - Vec3(0, 0, -200e3)).norm(), 0, 1);
}

TEST_F(Loads, WrongInputIsToldInTheDialogAndCreatesNothing) {
  trigger("Load on a block…");
  pickTop();
  type("vector#amount", "12 kg");
  EXPECT_FALSE(window->findChild<QPushButton*>(QStringLiteral("vector#create"))->isEnabled());
  type("vector#amount", "12 kN");
  auto* way = window->findChild<QComboBox*>(QStringLiteral("vector#direction"));
  way->setCurrentIndex(2);
  type("vector#trend", "90");
  type("vector#plunge", "0");
  create();
  ASSERT_EQ(project().loads.size(), 1u);
  EXPECT_NEAR((project().loads[0].force - Vec3(12e3, 0, 0)).norm(), 0, 1e-3);
  EXPECT_NEAR((project().loads[0].at - Vec3(2, 2, 2)).norm(), 0, 1e-6) << "at the block's centroid";
}

TEST_F(Loads, PointsFacesAndBlocksAreHeld) {
  trigger("Hold a point");
  pickTop();
  ASSERT_EQ(project().constraints.size(), 1u);
  EXPECT_EQ(*project().constraints[0].at, Vec3(1.5, 2.5, 3));
  trigger("Hold a face at its corners");
  pickTop();
  ASSERT_EQ(project().constraints.size(), 5u);
  EXPECT_EQ(undoText(), QStringLiteral("hold a face of cube"));
  for (std::size_t i = 1; i < 5; ++i) EXPECT_EQ(project().constraints[i].at->z(), 3);
  session->project.document().undoStack().undo();
  EXPECT_EQ(project().constraints.size(), 1u) << "one step";
  trigger("Hold a block");
  pickTop();
  EXPECT_EQ(project().solids[1].body, BodyKind::fixed) << "the cube is a solid that is left whole";
  EXPECT_EQ(undoText(), QStringLiteral("hold block cube"));
}

TEST_F(Loads, MonitorsAndVelocities) {
  trigger("Monitor with stress here");
  pickTop();
  ASSERT_EQ(project().monitors.size(), 2u);
  EXPECT_TRUE(project().monitors[1].stress);
  EXPECT_EQ(project().monitors[1].block, "cube");
  session->project.selection().selectBlocks({1});
  trigger("Velocity of blocks…");
  rest(20);
  type("vector#amount", "36 km/h");
  create();
  ASSERT_EQ(project().velocities.size(), 1u);
  EXPECT_NEAR((project().velocities[0].linear - Vec3(0, 0, -10)).norm(), 0, 1e-6);
}

TEST_F(Loads, AreDrawnOnTheirPagesAndSelectedByAClick) {
  Project changed = project();
  changed.loads = {{.block = "cube", .at = {2, 2, 3}, .force = {0, 0, -100e3}}};
  changed.constraints = {{.block = "base", .at = Vec3(30, 2, 1)}};
  session->project.document().change(changed, QStringLiteral("act"));
  rest(20);
  auto& view = window->viewport();
  EXPECT_EQ(view.actions().size(), 3u);  // with the monitor
  view.fit();
  rest(600);
  keepPicture(*window, "loads.png");
  auto* area = const_cast<RenderSurface&>(view.surface()).widget();
  std::map<ActionGlyph::Kind, QPoint> places;
  for (int y = 4; y < view.height(); y += 4)
    for (int x = 4; x < view.width(); x += 4)
      if (const auto glyph = view.actionAt(QPointF(x, y))) places[glyph->kind] = {x, y};
  for (const auto& [kind, item] : {std::pair{ActionGlyph::Kind::load, Item::Kind::load},
                                   {ActionGlyph::Kind::support, Item::Kind::constraint},
                                   {ActionGlyph::Kind::monitor, Item::Kind::monitor}}) {
    ASSERT_TRUE(places.contains(kind)) << static_cast<int>(item);
    QTest::mouseClick(area, Qt::LeftButton, {}, places[kind]);
    EXPECT_EQ(session->project.selection().current(), (Item{item, 0}));
  }
  session->display.goTo(WorkflowPage::geometry);
  EXPECT_TRUE(view.actions().empty());
  session->display.goTo(WorkflowPage::loads);
  auto* table = window->findChild<PageTable*>();
  EXPECT_EQ(table->rowCount(), 3) << "all that acts is listed";
  trigger("Show loads, supports and monitors");
  EXPECT_FALSE(session->display.settings().actions);
}

TEST_F(Loads, ThePlaceOfALoadIsPickedFromItsForm) {
  Project changed = project();
  changed.loads = {{.block = "base", .at = {20, 2, 1}, .force = {0, 0, -100e3}}};
  session->project.document().change(changed, QStringLiteral("act"));
  session->project.selection().select({Item::Kind::load, 0});
  rest(20);
  auto* button = window->findChild<QToolButton*>(QStringLiteral("/loads/0/at#pick"));
  ASSERT_NE(button, nullptr);
  QTest::mouseClick(button, Qt::LeftButton);
  pickTop();
  EXPECT_EQ(project().loads[0].at, Vec3(1.5, 2.5, 3));
  EXPECT_EQ(project().loads[0].block, "cube");
  session->project.document().undoStack().undo();
  EXPECT_EQ(project().loads[0].block, "base");
}

}  // namespace
}  // namespace talus
