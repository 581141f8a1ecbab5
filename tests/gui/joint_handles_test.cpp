#include "widgets/joints/joint_handles.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QLineF>
#include <QTest>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "orientation/cut_moves.hpp"
#include "widgets/orientation/stereonet_view.hpp"

namespace talus {
namespace {

using Kind = CutHandle::Kind;

/// A cube of 10 m with a plane, a disc and a polygon in it; the plane is selected on the Joints page.
class HandlesWindow : public DrivenWindow {
 protected:
  void SetUp() override {
    DrivenWindow::SetUp();
    window->open(write("handles.talus", R"({
      "talus": 1, "materials": {"rock": {"density": 2600, "young": 25e9, "poisson": 0.24}},
      // the bedding was measured in the adit
      "joints": {"A": {"friction_angle": 25}, "B": {"friction_angle": 35}}, "default_joint": "A",
      "solids": [{"name": "rock", "material": "rock", "body": "rigid", "box": {"min": [0, 0, 0], "max": [10, 10, 10]}}],
      "cuts": [{"joint": "A", "dip": 40, "dip_direction": 200, "through": [5, 5, 5]},
               {"joint": "B", "dip": 60, "dip_direction": 130, "disc": {"centre": [5, 5, 5], "radius": 3}},
               {"joint": "B", "dip": 0, "dip_direction": 0, "polygon": [[2, 2, 5], [8, 2, 5], [8, 8, 5], [2, 8, 5]]},
               {"joint": "A", "dip": 45, "dip_direction": 90, "through": [105, 5, -95]}],
      "stages": [{"name": "go", "type": "dynamic", "time_step": 0.01, "steps": 1}]})"));
    ASSERT_TRUE(session->project.document().isOpen());
    session->display.goTo(WorkflowPage::joints);
    ASSERT_TRUE(wait([&] { return session->surfaces.current() != nullptr && !session->surfaces.isBusy(); }));
    window->viewport().look(View::iso);
    select(0);
    before = textNow();
  }
  void select(int cut) {
    session->project.selection().select({Item::Kind::cut, cut});
    rest(60);
  }
  std::string textNow() const { return session->project.document().text(); }
  const Cut& cut(int index) const { return session->project.document().project().cuts.at(static_cast<size_t>(index)); }
  Cut shown(int index) const { return session->joints.cuts().at(static_cast<size_t>(index)); }
  QUndoStack& steps() { return session->project.document().undoStack(); }
  JointHandles& handles() { return *window->findChild<JointHandles*>(); }
  QWidget& area() { return *window->viewport().findChild<QWidget*>(QStringLiteral("view area")); }

  void send(QEvent::Type type, QPointF at, Qt::KeyboardModifiers keys) {
    const bool moves = type == QEvent::MouseMove;
    QMouseEvent event(type, at, area().mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, keys);
    QApplication::sendEvent(&area(), &event);
  }
  /// Takes a handle and pulls it, without letting go, to where it stands for `value`.
  QPointF pull(const CutHandle& handle, double value, Qt::KeyboardModifiers keys = {}) {
    const QPointF from = handles().knobOf(handle).value(), to = handles().knobOf(handle, value).value();
    send(QEvent::MouseButtonPress, from, keys);
    for (int i = 1; i <= 8; ++i) send(QEvent::MouseMove, from + (to - from) * i / 8, keys);
    rest(20);
    return to;
  }
  void drag(const CutHandle& handle, double value, Qt::KeyboardModifiers keys = {}) {
    send(QEvent::MouseButtonRelease, pull(handle, value, keys), keys);
    rest(20);
  }
  void typeKeys(const char* keys) {
    for (const char* key = keys; *key; ++key) QTest::keyClick(&area(), *key);
  }

  std::string before;
};

TEST_F(HandlesWindow, TheArcTurnsTheDipAndTheJointsFollow) {
  keepPicture(window->viewport(), "handles_coarse.png");
  rest(600);
  keepPicture(window->viewport(), "handles_fine.png");
  const QPointF at = pull({Kind::dip}, 55);
  EXPECT_NEAR(shown(0).dip, 55, 0.5);
  EXPECT_EQ(textNow(), before) << "the project is not changed before it is let go";
  EXPECT_EQ(steps().count(), 0);
  keepPicture(window->viewport(), "handle_dragged.png");
  send(QEvent::MouseButtonRelease, at, {});
  EXPECT_NEAR(cut(0).dip, 55, 0.5);
  EXPECT_EQ(cut(0).dip_direction, 200);
  EXPECT_EQ(cut(0).through, Vec3(5, 5, 5));
  ASSERT_EQ(steps().count(), 1);
  EXPECT_EQ(steps().undoText(), QStringLiteral("turn cut 1"));
  EXPECT_NE(textNow().find("measured in the adit"), std::string::npos);
  steps().undo();
  EXPECT_EQ(textNow(), before);
}

TEST_F(HandlesWindow, ThePoleOnTheStereonetFollows) {
  for (auto* action : window->findChildren<QAction*>())
    if (action->text() == QStringLiteral("Stereonet…")) action->trigger();
  rest(50);
  auto* net = window->findChild<StereonetView*>();
  ASSERT_NE(net, nullptr);
  const QPointF pole = net->pointOf(std::size_t{0});
  pull({Kind::dip}, 70);
  EXPECT_GT(QLineF(net->pointOf(std::size_t{0}), pole).length(), 20);
  QTest::keyClick(&area(), Qt::Key_Escape);
  EXPECT_LT(QLineF(net->pointOf(std::size_t{0}), pole).length(), 1);
}

TEST_F(HandlesWindow, TheRingTurnsTheDirectionAndShiftSnaps) {
  drag({Kind::direction}, 228.3);
  EXPECT_NEAR(cut(0).dip_direction, 228.3, 1);
  drag({Kind::direction}, 201.2, Qt::ShiftModifier);
  EXPECT_EQ(cut(0).dip_direction, 200);
  EXPECT_EQ(cut(0).dip, 40);
  EXPECT_EQ(steps().count(), 2) << "a drag is a step";
}

TEST_F(HandlesWindow, TheArrowMovesAlongTheNormal) {
  drag({Kind::move}, 1.5);
  EXPECT_NEAR(normal_of(cut(0)).dot(cut(0).through - Vec3(5, 5, 5)), 1.5, 0.1);
  EXPECT_LT(normal_of(cut(0)).cross(cut(0).through - Vec3(5, 5, 5)).norm(), 2e-3);
  EXPECT_EQ(steps().undoText(), QStringLiteral("move cut 1"));
}

TEST_F(HandlesWindow, EscapeTakesADragBackToTheByte) {
  const QPointF at = pull({Kind::dip}, 80);
  EXPECT_GT(shown(0).dip, 70);
  QTest::keyClick(&area(), Qt::Key_Escape);
  EXPECT_EQ(shown(0), cut(0));
  send(QEvent::MouseMove, at + QPointF(9, 9), {});
  send(QEvent::MouseButtonRelease, at, {});
  EXPECT_EQ(textNow(), before);
  EXPECT_EQ(steps().count(), 0);
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::cut, 0})) << "it stays selected";
}

TEST_F(HandlesWindow, ANumberCanBeTypedWhileDragging) {
  pull({Kind::dip}, 50);
  typeKeys("62.5");
  EXPECT_EQ(shown(0).dip, 62.5);
  keepPicture(window->viewport(), "handle_typed.png");
  QTest::keyClick(&area(), Qt::Key_Return);
  EXPECT_EQ(cut(0).dip, 62.5);
  EXPECT_EQ(steps().count(), 1);
}

TEST_F(HandlesWindow, ArrowKeysNudgeTheHandleThatWasClicked) {
  const QPointF knob = *handles().knobOf({Kind::dip});
  send(QEvent::MouseButtonPress, knob, {});
  send(QEvent::MouseButtonRelease, knob, {});
  EXPECT_EQ(steps().count(), 0) << "a click alone changes nothing";
  for (int i = 0; i < 3; ++i) QTest::keyClick(&area(), Qt::Key_Up);
  EXPECT_EQ(cut(0).dip, 43);
  QTest::keyClick(&area(), Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_EQ(cut(0).dip, 38);
  EXPECT_EQ(steps().count(), 1) << "nudges of one handle are one step";
  QTest::keyClick(&area(), Qt::Key_Tab);
  QTest::keyClick(&area(), Qt::Key_Right);
  EXPECT_NEAR(normal_of(cut(0)).dot(cut(0).through - Vec3(5, 5, 5)), 0.1, 2e-3) << "Tab goes on to the arrow";
}

TEST_F(HandlesWindow, ADiscHasItsRadius) {
  select(1);
  drag({Kind::radius}, 2);
  EXPECT_NEAR(cut(1).disc->radius, 2, 0.1);
  drag({Kind::dip}, 70);
  EXPECT_EQ(cut(1).disc->centre, Vec3(5, 5, 5));
}

TEST_F(HandlesWindow, APolygonHasItsCorners) {
  select(2);
  const CutHandle corner{Kind::corner, 2};
  const QPointF from = *handles().knobOf(corner), to = *window->viewport().pointOf(Vec3(9, 9, 5));
  send(QEvent::MouseButtonPress, from, {});
  for (int i = 1; i <= 4; ++i) send(QEvent::MouseMove, from + (to - from) * i / 4, {});
  send(QEvent::MouseButtonRelease, to, {});
  EXPECT_NEAR(cut(2).polygon[2].x(), 9, 0.1);
  EXPECT_NEAR(cut(2).polygon[2].y(), 9, 0.1);
  EXPECT_NEAR(cut(2).polygon[2].z(), 5, 1e-9);
  EXPECT_EQ(cut(2).polygon[0], Vec3(2, 2, 5));
}

TEST_F(HandlesWindow, APlaneThatGoesThroughAPointFarAwayIsHeldInTheRock) {
  select(3);  // x + z = 10 through a point far outside
  const auto knob = handles().knobOf({Kind::dip});
  ASSERT_TRUE(knob.has_value());
  EXPECT_TRUE(area().rect().contains(knob->toPoint()));
  drag({Kind::dip}, 55);
  EXPECT_NEAR(cut(3).through.x(), 5, 0.1) << "it is turned about the middle of what is seen of it";
  EXPECT_NEAR(cut(3).through.z(), 5, 0.1);
}

TEST_F(HandlesWindow, AClickOnAPlaneSelectsItsCutAndTheSwitchHidesAll) {
  select(0);
  session->project.selection().clear();
  rest(50);
  const auto at = *window->viewport().pointOf(Vec3(5, 5, 5));
  const auto cutThere = window->viewport().jointAt(at);
  ASSERT_TRUE(cutThere.has_value());
  QTest::mouseClick(&area(), Qt::LeftButton, {}, at.toPoint());
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::cut, *cutThere}));
  const QImage with = window->viewport().picture().toImage();
  SceneSettings settings = session->display.settings();
  settings.joints = false;
  session->display.set(settings);
  rest(50);
  EXPECT_FALSE(window->viewport().jointAt(at).has_value());
  EXPECT_FALSE(handles().knobOf({Kind::dip}).has_value());
  EXPECT_NE(window->viewport().picture().toImage(), with);
  settings.joints = true;
  session->display.set(settings);
  session->display.goTo(WorkflowPage::geometry);
  EXPECT_FALSE(window->viewport().jointAt(at).has_value()) << "joints are drawn on their page alone";
}

/// A bench with three sets, one of them by chance.
std::string bench() {
  return R"({
    "talus": 1, "name": "Quarry bench", "materials": {"limestone": {"density": 2650, "young": 25e9, "poisson": 0.24}},
    "joints": {"bedding": {"friction_angle": 28}, "J1": {"friction_angle": 35}, "J2": {"friction_angle": 35},
               "fault": {"friction_angle": 16, "cohesion": 12e3, "residual_friction_angle": 11}},
    "default_joint": "J1",
    "solids": [{"name": "bench", "material": "limestone", "body": "rigid", "polyhedron": {
      "vertices": [[0, 0, 0], [60, 0, 0], [60, 40, 0], [0, 40, 0], [0, 0, 8], [14, 0, 8], [20, 0, 24], [60, 0, 24],
                   [0, 40, 8], [14, 40, 8], [20, 40, 24], [60, 40, 24]],
      "faces": [[0, 3, 2, 1], [0, 1, 7, 6, 5, 4], [3, 8, 9, 10, 11, 2], [0, 4, 8, 3], [1, 2, 11, 7], [4, 5, 9, 8],
                [5, 6, 10, 9], [6, 7, 11, 10]]}}],
    "cuts": [
      {"joint": "bedding", "dip": 32, "dip_direction": 270, "through": [30, 20, 2], "spacing": 5, "count": 4},
      {"joint": "J1", "dip": 82, "dip_direction": 185, "through": [30, 6, 12], "spacing": 9, "count": 4,
       "fisher_kappa": 300, "spacing_law": "exponential", "ends_at": ["fault"]},
      {"joint": "J2", "dip": 76, "dip_direction": 92, "disc": {"centre": [36, 22, 14], "radius": 9}},
      {"joint": "fault", "dip": 68, "dip_direction": 250, "through": [44, 20, 12]}],
    "stages": [{"name": "go", "type": "dynamic", "time_step": 0.01, "steps": 1}]})";
}

double areaOf(const JointFace& face) {
  double sum = 0;
  for (const FlatTriangle& t : face.triangles) sum += (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
  return sum;
}

TEST_F(HandlesWindow, ANetworkIsDrawnAsItsDiscsAsFarAsTheyAreInTheRock) {
  const auto withNetwork = [&](double from, double to) {
    Project changed = session->project.document().project();
    Cut network;
    network.joint = "B";
    network.dip = 30;
    network.fisher_kappa = 20;
    network.network = JointNetwork{{Vec3::Constant(from), Vec3::Constant(to)}, 2, 0.4};
    network.through = Vec3::Constant((from + to) / 2);
    changed.cuts.resize(4);
    changed.cuts.push_back(network);
    session->project.document().change(changed, QStringLiteral("network"));
    const auto before = session->joints.faces();
    EXPECT_TRUE(wait([&] { return session->joints.faces() != before; }));
    return areaOf(session->joints.faces()->at(4));
  };
  constexpr double drawn = 0.92;  // of a circle is a polygon of nine corners, as more than 800 discs have
  EXPECT_NEAR(withNetwork(2, 8), drawn * 2 * 6 * 6 * 6, 5);
  rest(60);
  keepPicture(window->viewport(), "network.png");
  EXPECT_NEAR(withNetwork(5, 15), 2 * 5 * 5 * 5, 30) << "an eighth of the box lies in the rock";
  EXPECT_EQ(session->joints.faces(), session->joints.faces()) << "nothing is drawn again";
}

TEST_F(HandlesWindow, APictureThatIsSavedHasTheJoints) {
  const auto saved = [&](const char* name) {
    window->savePicture(folder / name, 640);
    EXPECT_TRUE(wait([&] { return !window->exporter().isBusy(); }));
    return QImage(QString::fromStdString((folder / name).string()));
  };
  const QImage with = saved("with.png");
  keepPicture(*window, "joints_saved.png");
  session->project.selection().select({Item::Kind::cut, 1});
  EXPECT_NE(saved("other.png"), with) << "the chosen one is drawn stronger";
  SceneSettings settings = session->display.settings();
  settings.joints = false;
  session->display.set(settings);
  EXPECT_NE(saved("without.png"), with);
}

TEST_F(HandlesWindow, TheCameraStaysFromTheSolidsToTheBlocksAndBack) {
  window->viewport().look(View::front);
  const CameraPose pose = *window->viewport().pose();
  const auto stands = [&] {
    const CameraPose now = *window->viewport().pose();
    return (now.position - pose.position).norm() + (now.focal_point - pose.focal_point).norm() < 1e-9;
  };
  Project changed = session->project.document().project();
  changed.cuts.resize(1);
  session->project.document().change(changed, QStringLiteral("one cut"));
  session->display.goTo(WorkflowPage::blocks);
  session->run.mesh();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
  ASSERT_EQ(window->viewport().shown(), session->project.system());
  EXPECT_TRUE(stands()) << "blocks have come";
  session->project.selection().selectBlocks({0});
  window->viewport().hideSelected();
  session->display.goTo(WorkflowPage::joints);
  EXPECT_TRUE(window->viewport().showsSolids());
  EXPECT_TRUE(stands()) << "the solids again";
  session->display.goTo(WorkflowPage::blocks);
  EXPECT_TRUE(stands());
  EXPECT_EQ(window->viewport().hiddenBlocks(), std::vector<int>{0}) << "what was hidden stays so";
  session->open(write("other.talus", bench()));
  ASSERT_TRUE(wait([&] { return window->viewport().shown() && !session->surfaces.isBusy(); }));
  EXPECT_FALSE(stands()) << "another project is looked at anew";
}

TEST_F(HandlesWindow, ThePageHasRoomInBothThemes) {
  write("bench.talus", bench());
  for (const QSize size : {QSize(1280, 720), QSize(1600, 1000)})
    for (const bool dark : {false, true}) {
      openWindow();
      window->resize(size);
      window->open(folder / "bench.talus");
      session->display.setDark(dark);
      session->display.goTo(WorkflowPage::joints);
      ASSERT_TRUE(wait([&] { return session->surfaces.current() != nullptr && !session->surfaces.isBusy(); }));
      select(0);
      rest(500);
      EXPECT_EQ(window->size(), size);
      EXPECT_GE(window->viewport().height(), 300);
      for (const CutHandle& handle : handlesOf(cut(0)))
        EXPECT_TRUE(area().rect().contains(handles().knobOf(handle).value().toPoint()));
      const std::string name = "joints_page_" + std::to_string(size.width()) + (dark ? "_dark.png" : "_light.png");
      keepPicture(*window, name.c_str());
    }
  session->display.setDark(false);
}

}  // namespace
}  // namespace talus
