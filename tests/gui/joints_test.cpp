#include <QAction>
#include <QApplication>
#include <QHeaderView>
#include <QMenu>

#include "driven_form.hpp"
#include "listed_runs.hpp"
#include "session/picking.hpp"
#include "widgets/orientation/paste_joints.hpp"
#include "widgets/project/page_table.hpp"

namespace talus {
namespace {

/// A cube of 10 m that two joints cut, beside one that lies on it.
class JointsWindow : public DrivenForm {
 protected:
  void SetUp() override {
    DrivenForm::SetUp();
    window->open(write("joints.talus", R"({
      "talus": 1, "materials": {"rock": {"density": 2600, "young": 25e9, "poisson": 0.24}},
      "joints": {"A": {"friction_angle": 25}, "B": {"friction_angle": 35, "cohesion": 1000}}, "default_joint": "A",
      "solids": [
        {"name": "rock", "material": "rock", "body": "rigid", "box": {"min": [0, 0, 0], "max": [10, 10, 10]}},
        {"name": "cap", "material": "rock", "body": "rigid", "box": {"min": [4, 4, 10], "max": [8, 8, 13]}}],
      "cuts": [{"joint": "A", "dip": 40, "dip_direction": 90, "through": [5, 5, 3]},
               {"joint": "B", "dip": 9, "dip_direction": 200, "through": [5, 5, 2], "spacing": 2, "count": 2}],
      "stages": [{"name": "go", "type": "dynamic", "time_step": 0.01, "steps": 1}]})"));
    ASSERT_TRUE(session->project.document().isOpen());
  }
  void mesh() {
    session->run.mesh();
    ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
    ASSERT_NE(session->project.system(), nullptr);
    rest(50);
  }
  const Project& rock() const { return session->project.document().project(); }
  std::string textNow() const { return session->project.document().text(); }
  void trigger(const char* action) {
    for (auto* one : window->findChildren<QAction*>())
      if (one->text() == QString::fromUtf8(action)) {
        one->trigger();
        rest(20);
        return;
      }
    ADD_FAILURE() << action;
  }
  void clickAt(const Vec3& place) {
    const auto at = window->viewport().pointOf(place);
    ASSERT_TRUE(at.has_value());
    QTest::mouseClick(&area(), Qt::LeftButton, {}, at->toPoint());
    rest(20);
  }
  void chooseInMenu(const char* entry) {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    ASSERT_NE(menu, nullptr);
    for (auto* action : menu->actions())
      if (action->text() == QLatin1String(entry)) action->trigger();
    menu->close();
    rest(20);
  }
  PageTable& table() { return *window->findChild<PageTable*>(); }
  void undo() { session->project.document().undoStack().undo(); }
};

TEST_F(JointsWindow, AJointGoesThroughThreePointsThatAreClicked) {
  mesh();
  window->viewport().look(View::iso);
  rest(50);
  const std::string before = textNow();
  trigger("Joint through three points");
  EXPECT_EQ(session->display.page(), WorkflowPage::joints);
  for (const Vec3& place : {Vec3(2, 0.5, 10), Vec3(4, 0, 8), Vec3(8, 0, 4)}) clickAt(place);  // x + z = 12
  ASSERT_EQ(rock().cuts.size(), 3u);
  const Cut& made = rock().cuts.back();
  EXPECT_NEAR(made.dip, 45, 2);
  EXPECT_NEAR(made.dip_direction, 90, 6);
  EXPECT_NEAR(made.through.x() + made.through.z(), 12, 0.2);
  EXPECT_EQ(made.joint, "A");
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::cut, 2}));
  EXPECT_EQ(session->project.document().undoStack().undoText(), QStringLiteral("joint through three points"));
  undo();
  EXPECT_EQ(textNow(), before);
}

TEST_F(JointsWindow, APlaceOnABlockIsFoundOnTheRockThatIsNotCutToo) {
  mesh();
  const int last = static_cast<int>(session->project.system()->blocks.size()) - 1;
  ASSERT_GE(last, 3) << "there are two solids";
  const PickedPlace place{.block = last, .solid = 1, .point = {4, 4, 13}};
  EXPECT_TRUE(window->viewport().pointOf(place).has_value());
  session->display.goTo(WorkflowPage::joints);
  ASSERT_TRUE(wait([&] { return session->surfaces.current() && !session->surfaces.isBusy(); }));
  rest(50);
  EXPECT_EQ(window->viewport().pointOf(place), window->viewport().pointOf(place.point));
}

TEST_F(JointsWindow, AJointLiesAlongAFaceThatIsClicked) {
  mesh();
  window->viewport().look(View::iso);
  rest(50);
  session->project.selection().select({Item::Kind::joint, 1});
  trigger("Joint along a face");
  clickAt({5, 0, 9});
  ASSERT_EQ(rock().cuts.size(), 3u);
  EXPECT_NEAR(rock().cuts.back().dip, 90, 1e-6);
  EXPECT_NEAR(std::fmod(rock().cuts.back().dip_direction, 180), 0, 1e-6);
  EXPECT_NEAR(rock().cuts.back().through.y(), 0, 1e-3);
  EXPECT_EQ(rock().cuts.back().joint, "B") << "of the joint that is selected";
}

TEST_F(JointsWindow, AJointIsAssignedToAFaceBetweenTwoBlocks) {
  mesh();
  window->viewport().toggleExplosion();
  rest(50);
  trigger("Assign joint to a face");
  chooseInMenu("B");
  ASSERT_TRUE(session->picking.isAsking());
  const BlockSystem& system = *session->project.system();
  int below = -1;
  for (std::size_t b = 0; b < system.blocks.size(); ++b)
    for (const Vec3& node : system.blocks[b].mesh.nodes)
      if (system.blocks[b].solid == 0 && node.isApprox(Vec3(10, 10, 10))) below = static_cast<int>(b);
  PickedPlace place;
  place.block = below;
  place.point = {5, 4.5, 10};
  const auto at = window->viewport().pointOf(place);
  ASSERT_TRUE(at && window->viewport().pickAt(*at));
  QTest::mouseClick(&area(), Qt::LeftButton, {}, at->toPoint());
  rest(20);
  ASSERT_EQ(rock().interfaces.size(), 1u);
  EXPECT_EQ(rock().interfaces[0].joint, "B");
  EXPECT_EQ(rock().interfaces[0].between[1], "cap");
  undo();
  EXPECT_TRUE(rock().interfaces.empty());
}

TEST_F(JointsWindow, AFaceOnACutIsToldWithItsCut) {
  mesh();
  window->viewport().toggleExplosion();
  rest(50);
  trigger("Assign joint to a face");
  chooseInMenu("B");
  const Viewport& view = window->viewport();
  for (int y = 10; y < view.height() && session->picking.isAsking(); y += 6)
    for (int x = 10; x < view.width() && session->picking.isAsking(); x += 6)
      if (const auto pick = view.pickAt(QPointF(x, y)); pick && view.placeOf(*pick).joint == 0)
        QTest::mouseClick(&area(), Qt::LeftButton, {}, QPoint(x, y));
  ASSERT_FALSE(session->picking.isAsking()) << "no face on joint A is in view";
  EXPECT_TRUE(rock().interfaces.empty());
  ASSERT_FALSE(session->messages.problems().empty());
  const Problem& said = session->messages.problems().back();
  EXPECT_NE(said.problem.toStdString().find("cut 1, which has the joint A"), std::string::npos)
      << said.problem.toStdString();
  EXPECT_EQ(said.field, QStringLiteral("/cuts/0/joint"));
}

TEST_F(JointsWindow, TwoSelectedBlocksAreGivenAJoint) {
  mesh();
  session->project.selection().selectBlocks({0, 1});
  trigger("Joint between these two blocks");
  chooseInMenu("B");
  ASSERT_EQ(rock().interfaces.size(), 1u);
  EXPECT_EQ(rock().interfaces[0].joint, "B");
}

TEST_F(JointsWindow, ATypicalStrengthSetsItsValues) {
  session->display.goTo(WorkflowPage::joints);
  session->project.selection().select({Item::Kind::joint, 1});
  choose("/joints/B#strengths", QStringLiteral("clay mylonite in coal measures, 10 to 25 mm"));
  const Joint& filled = rock().joints[1];
  EXPECT_EQ(filled.friction_angle, 16);
  EXPECT_EQ(filled.cohesion, 12e3);
  EXPECT_EQ(filled.residual_friction_angle, 11);
  rest(20);
  auto* box = widget<QComboBox>("/joints/B#strengths");
  ASSERT_NE(box, nullptr);
  EXPECT_NE(box->toolTip().indexOf(QStringLiteral("Barton 1974")), -1) << box->toolTip().toStdString();
  choose("/joints/B#strengths", QStringLiteral("limestone, dry"));
  EXPECT_EQ(rock().joints[1].friction_angle, 34);
  EXPECT_EQ(rock().joints[1].cohesion, 0);
  EXPECT_FALSE(rock().joints[1].residual_friction_angle);
  choose("/joints/B#stiffnesses", QStringLiteral("soft clay in the joint"));
  EXPECT_EQ(rock().joints[1].normal_stiffness, 5e7);
  EXPECT_EQ(rock().joints[1].shear_stiffness, 5e7);
  EXPECT_EQ(rock().joints[1].friction_angle, 34) << "the strength stays";
  undo();
  undo();
  undo();
  EXPECT_EQ(rock().joints[1].friction_angle, 35);
  EXPECT_FALSE(rock().joints[1].normal_stiffness);
}

TEST_F(JointsWindow, FacesOfADrawingBecomeJointsThatEnd) {
  std::string drawing = "0\nSECTION\n2\nENTITIES\n";
  for (const char* layer : {"A", "fault"}) {
    drawing += std::string("0\n3DFACE\n8\n") + layer + "\n";
    const double corners[4][3] = {{0, 0, 8}, {8, 0, 0}, {8, 8, 0}, {0, 8, 8}};
    for (int corner = 0; corner < 4; ++corner)
      for (int axis = 0; axis < 3; ++axis)
        drawing += std::to_string(10 * (axis + 1) + corner) + "\n" + std::to_string(corners[corner][axis]) + "\n";
  }
  window->takeDropped(write("faces.dxf", drawing + "0\nENDSEC\n0\nEOF\n"));
  rest(50);
  auto* dialog = window->findChild<PasteJoints*>();
  ASSERT_NE(dialog, nullptr);
  keepPicture(*dialog, "drawing.png");
  QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("add")), Qt::LeftButton);
  ASSERT_EQ(rock().cuts.size(), 4u);
  EXPECT_NEAR(rock().cuts[2].dip, 45, 1e-6);
  EXPECT_NEAR(rock().cuts[2].dip_direction, 90, 1e-6);
  EXPECT_EQ(rock().cuts[3].polygon.size(), 4u);
  EXPECT_EQ(rock().cuts[3].joint, "fault");
  undo();
  EXPECT_EQ(rock().cuts.size(), 2u);
}

TEST_F(JointsWindow, TheTableIsSortedAndADoubleClickOpensTheField) {
  session->display.goTo(WorkflowPage::joints);
  rest(20);
  ASSERT_EQ(table().rowCount(), 2);
  EXPECT_EQ(table().item(0, 0)->text(), QStringLiteral("A"));
  EXPECT_NE(table().item(1, 2)->text().indexOf(QStringLiteral("infinite")), -1);
  auto* head = table().horizontalHeader();
  const QPoint dip(head->sectionViewportPosition(4) + 20, head->height() / 2);
  QTest::mouseClick(head->viewport(), Qt::LeftButton, {}, dip);
  EXPECT_EQ(table().item(0, 0)->text(), QStringLiteral("B")) << "9 is less than 40, by number";
  session->project.selection().select({Item::Kind::cut, 0});
  EXPECT_EQ(table().currentRow(), 1);
  const QPoint cell = table().visualItemRect(table().item(0, 4)).center();
  QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, cell);
  QTest::mouseDClick(table().viewport(), Qt::LeftButton, {}, cell);
  rest(50);
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::cut, 1}));
  ASSERT_NE(QApplication::focusWidget(), nullptr);
  EXPECT_EQ(QApplication::focusWidget()->objectName(), QStringLiteral("/cuts/1/dip"));
  QTest::mouseClick(head->viewport(), Qt::LeftButton, {}, dip);
  EXPECT_EQ(table().item(0, 0)->text(), QStringLiteral("A"));
}

}  // namespace
}  // namespace talus
