#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QToolButton>
#include <cmath>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/tokens.hpp"
#include "widgets/orientation/net_artist.hpp"
#include "widgets/orientation/paste_joints.hpp"
#include "widgets/orientation/stereonet_panel.hpp"
#include "widgets/orientation/stereonet_view.hpp"

namespace talus {
namespace {

/// A box cut by two joints of set A, which dip east at 40° and 50°, and one of set B.
class StereonetWindow : public DrivenWindow {
 protected:
  void SetUp() override {
    DrivenWindow::SetUp();
    window->open(write("joints.talus", R"({
      "talus": 1, "materials": {"rock": {"density": 2600, "young": 25e9, "poisson": 0.24}},
      "joints": {"A": {"friction_angle": 25}, "B": {"friction_angle": 35}}, "default_joint": "A",
      "solids": [{"name": "rock", "material": "rock", "body": "rigid", "box": {"min": [0, 0, 0], "max": [10, 10, 10]}}],
      "cuts": [{"joint": "A", "dip": 40, "dip_direction": 90, "through": [5, 5, 5]},
               {"joint": "A", "dip": 50, "dip_direction": 90, "through": [5, 5, 5]},
               {"joint": "B", "dip": 80, "dip_direction": 200, "through": [5, 5, 5]}],
      "stages": [{"name": "go", "type": "dynamic", "time_step": 0.01, "steps": 1}]})"));
    ASSERT_TRUE(session->project.document().isOpen());
  }

  template <class Dialog>
  Dialog& opened(const char* action) {
    for (auto* one : window->findChildren<QAction*>())
      if (one->text() == QString::fromUtf8(action)) one->trigger();
    rest(50);
    return *window->findChild<Dialog*>();
  }
  StereonetPanel& panel() { return opened<StereonetPanel>("Stereonet…"); }
  PasteJoints& paste(const char* clipboard) {
    QApplication::clipboard()->setText(QString::fromUtf8(clipboard));
    return opened<PasteJoints>("Paste joints…");
  }
  const Project& project() const { return session->project.document().project(); }

  static PlainTable& table(const QWidget& widget, const char* name) {
    return *widget.findChild<PlainTable*>(QLatin1String(name));
  }
  static std::string cell(const PlainTable& table, int row, int column) {
    return table.item(row, column)->text().toStdString();
  }
  static std::string said(const QWidget& widget, const char* name) {
    return widget.findChild<QLabel*>(QLatin1String(name))->text().toStdString();
  }
  void type(QWidget& widget, const char* field, const char* number) {
    for (auto* one : widget.findChildren<NumberField*>()) {
      if (one->accessibleName() != QLatin1String(field)) continue;
      one->setFocus();
      one->selectAll();
      QTest::keyClicks(one, QLatin1String(number));
      QTest::keyClick(one, Qt::Key_Return);
      return;
    }
    ADD_FAILURE() << field;
  }
  void drag(StereonetView& view, const Vec3& from, const Vec3& to, Qt::KeyboardModifiers keys = {}) {
    const QPoint start = view.pointOf(from).toPoint(), end = view.pointOf(to).toPoint();
    QTest::mousePress(&view, Qt::LeftButton, keys, start);
    for (int i = 1; i <= 5; ++i) {
      QMouseEvent move(QEvent::MouseMove, start + (end - start) * i / 5.0,
                       view.mapToGlobal(start + (end - start) * i / 5.0), Qt::NoButton, Qt::LeftButton, keys);
      QApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, keys, end);
  }
};

TEST_F(StereonetWindow, TellsTheSetsWithMeanAndKappa) {
  const PlainTable& sets = table(panel(), "sets");
  ASSERT_EQ(sets.rowCount(), 2);
  EXPECT_EQ(cell(sets, 0, 0), "A");
  EXPECT_EQ(cell(sets, 0, 2), "45.0/90.0");
  EXPECT_EQ(cell(sets, 0, 3), "131");  // 1/(2 − 2 cos 5°)
  EXPECT_EQ(cell(sets, 1, 1), "1");
  EXPECT_EQ(cell(sets, 1, 3), "–");
}

TEST_F(StereonetWindow, TheTableOfSetsLiesBelowItsHeading) {
  auto& net = panel();
  net.resize(1100, 900);  // more than its side needs
  rest(50);
  const PlainTable& sets = table(net, "sets");
  EXPECT_EQ(sets.parentWidget()->height(), sets.parentWidget()->sizeHint().height());
}

TEST_F(StereonetWindow, AClickOnAPoleSelectsItsCutAndASelectionIsShown) {
  StereonetPanel& net = panel();
  auto& view = *net.findChild<StereonetView*>();
  QTest::mouseClick(&view, Qt::LeftButton, {}, view.pointOf(2).toPoint());
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::cut, 2}));
  const QImage before = view.grab().toImage();
  session->project.selection().select({Item::Kind::joint, 0});  // as from the tree: both of set A
  EXPECT_NE(view.grab().toImage(), before);
  QTest::keyClick(&view, Qt::Key_Right);
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::cut, 2}));
  QTest::keyClick(&view, Qt::Key_Right);
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::cut, 0}));
  QTest::mouseClick(&view, Qt::LeftButton, {}, view.pointOf(pole_of({45, 0})).toPoint());
  EXPECT_EQ(session->project.selection().current(), Item{});
}

TEST_F(StereonetWindow, ADraggedWindowPicksASetThatCanBeAssigned) {
  StereonetPanel& net = panel();
  auto& view = *net.findChild<StereonetView*>();
  drag(view, pole_of({30, 80}), pole_of({60, 100}));
  EXPECT_NE(said(net, "picked").find("2 poles"), std::string::npos) << said(net, "picked");
  EXPECT_NE(said(net, "picked").find("mean 45.0/90.0,  κ 131"), std::string::npos) << said(net, "picked");
  EXPECT_FALSE(button(net, "Assign").isEnabled());
  auto* name = net.findChild<QLineEdit*>();
  for (auto* one : net.findChildren<QLineEdit*>())
    if (one->accessibleName() == QStringLiteral("Name of the joint set")) name = one;
  name->setFocus();
  QTest::keyClicks(name, QStringLiteral("bedding"));
  ASSERT_TRUE(button(net, "Assign").isEnabled());
  click(button(net, "Assign"));
  EXPECT_EQ(project().cuts[0].joint, "bedding");
  EXPECT_EQ(project().cuts[2].joint, "B");
  ASSERT_EQ(project().joints.size(), 3u);
  EXPECT_EQ(project().joints[2].friction_angle, 25);
  session->project.document().undoStack().undo();
  EXPECT_EQ(project().cuts[0].joint, "A");
  EXPECT_EQ(project().joints.size(), 2u);
}

TEST_F(StereonetWindow, AConeIsDraggedWithShiftAndAWindowOverTheRim) {
  StereonetPanel& net = panel();
  auto& view = *net.findChild<StereonetView*>();
  drag(view, pole_of({80, 200}), pole_of({70, 200}), Qt::ShiftModifier);
  EXPECT_NE(said(net, "picked").find("1 pole in"), std::string::npos) << said(net, "picked");
  EXPECT_NE(said(net, "picked").find("~"), std::string::npos) << said(net, "picked");
  // From a plane that dips 75° north-north-east over the rim: 105° is 75° south-south-west, where B lies at 80°.
  drag(view, pole_of({75, 10}), pole_of({105, 30}));
  EXPECT_NE(said(net, "picked").find("1 pole in"), std::string::npos) << said(net, "picked");
}

TEST_F(StereonetWindow, CountsWhatCanFailInTheFaceThatIsTyped) {
  StereonetPanel& net = panel();
  PlainTable& counts = table(net, "counts");
  EXPECT_FALSE(counts.isVisible());
  type(net, "Face dip", "65");
  type(net, "Face dip direction", "90");
  ASSERT_TRUE(counts.isVisible());
  EXPECT_EQ(cell(counts, 0, 1), "2 of 3");
  type(net, "Friction angle of the check", "45");
  EXPECT_EQ(cell(counts, 0, 1), "1 of 3");
  type(net, "Face dip", "95");
  EXPECT_EQ(cell(counts, 0, 1), "1 of 3") << "what is impossible is refused";
  type(net, "Face dip", "60");
  rest(50);
  keepPicture(net, "stereonet.png");
  session->display.setDark(true);
  rest(50);
  keepPicture(net, "stereonet_dark.png");
  session->display.setDark(false);
  for (auto* field : net.findChildren<NumberField*>())
    if (field->accessibleName() == QStringLiteral("Face dip")) {
      field->setFocus();
      field->selectAll();
      QTest::keyClick(field, Qt::Key_Delete);
      QTest::keyClick(field, Qt::Key_Return);
    }
  EXPECT_FALSE(counts.isVisible()) << "no face, no counts";
}

TEST_F(StereonetWindow, TheFaceOfTheCheckIsPickedInTheView) {
  StereonetPanel& net = panel();
  auto* pick = net.findChild<QToolButton*>(QStringLiteral("pick face"));
  ASSERT_NE(pick, nullptr);
  const auto typed = [&](const char* field) {
    for (auto* one : net.findChildren<NumberField*>())
      if (one->accessibleName() == QLatin1String(field)) return one->text().toStdString();
    return std::string();
  };
  QTest::mouseClick(pick, Qt::LeftButton);
  EXPECT_FALSE(net.isVisible()) << "it makes way for the rock";
  ASSERT_TRUE(session->picking.isAsking());
  const double half = std::sqrt(0.5);
  session->picking.take({.solid = 0, .point = {10, 5, 5}, .normal = {half, 0, half}});
  EXPECT_TRUE(net.isVisible());
  EXPECT_EQ(typed("Face dip"), "45 °");
  EXPECT_EQ(typed("Face dip direction"), "90 °");
  EXPECT_EQ(cell(table(net, "counts"), 0, 1), "1 of 3") << "40° daylights, 50° does not";
  QTest::mouseClick(pick, Qt::LeftButton);
  session->picking.take({.solid = 0, .point = {0, 5, 5}, .normal = {-1, 0, 0}});
  EXPECT_EQ(typed("Face dip"), "90 °");
  EXPECT_EQ(typed("Face dip direction"), "270 °") << "an upright face looks to where the rock ends";
  QTest::mouseClick(pick, Qt::LeftButton);
  session->picking.take({.solid = 0, .point = {5, 5, 0}, .normal = {0, 0, -1}});
  EXPECT_EQ(typed("Face dip direction"), "270 °") << "below the rock nothing slides out";
  EXPECT_FALSE(session->messages.problems().empty());
  QTest::mouseClick(pick, Qt::LeftButton);
  session->picking.cancel();
  EXPECT_TRUE(net.isVisible()) << "it comes back when the asking ends, too";
}

/// Three sets that scatter, 120 planes in all.
std::string survey() {
  return R"({
    "talus": 1, "materials": {"rock": {"density": 2600, "young": 25e9, "poisson": 0.24}},
    "joints": {"bedding": {"friction_angle": 28}, "J1": {"friction_angle": 35}, "J2": {"friction_angle": 35}},
    "default_joint": "J1",
    "solids": [{"name": "rock", "material": "rock", "body": "rigid", "box": {"min": [0, 0, 0], "max": [90, 90, 60]}}],
    "cuts": [
      {"joint": "bedding", "dip": 42, "dip_direction": 140, "through": [45, 45, 0], "spacing": 2, "count": 50,
       "fisher_kappa": 90},
      {"joint": "J1", "dip": 86, "dip_direction": 50, "through": [10, 10, 30], "spacing": 3, "count": 40,
       "fisher_kappa": 60, "seed": 2},
      {"joint": "J2", "dip": 74, "dip_direction": 318, "through": [80, 10, 30], "spacing": 3, "count": 30,
       "fisher_kappa": 120, "seed": 3}],
    "stages": [{"name": "go", "type": "dynamic", "time_step": 0.01, "steps": 1}]})";
}

TEST_F(StereonetWindow, ShowsEveryPlaneOfASetThatIsDrawn) {
  window->open(write("survey.talus", survey()));
  StereonetPanel& net = panel();
  ASSERT_EQ(table(net, "sets").rowCount(), 3);
  EXPECT_EQ(cell(table(net, "sets"), 0, 1), "50");
  auto& view = *net.findChild<StereonetView*>();
  QTest::keyClick(&view, Qt::Key_Left);  // the last pole
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::cut, 2}));
}

TEST_F(StereonetWindow, FitsIntoTheWindowInBothThemes) {
  write("survey.talus", survey());
  for (const QSize size : {QSize(1280, 720), QSize(1600, 1000)})
    for (const bool dark : {false, true}) {
      openWindow();
      window->resize(size);
      window->open(folder / "survey.talus");
      session->display.setDark(dark);
      StereonetPanel& net = panel();
      type(net, "Face dip", "65");
      type(net, "Face dip direction", "140");
      auto& view = *net.findChild<StereonetView*>();
      drag(view, pole_of({30, 115}), pole_of({55, 165}));
      session->project.selection().select({Item::Kind::cut, 2});
      rest(50);
      EXPECT_TRUE(QRect(QPoint(0, 0), size).contains(net.rect())) << net.width() << " x " << net.height();
      EXPECT_GE(std::min(view.width(), view.height()), 560);
      EXPECT_NE(said(net, "picked").find(" poles in "), std::string::npos) << said(net, "picked");
      const std::string name = std::to_string(size.width()) + (dark ? "_dark" : "_light");
      keepPicture(net, ("stereonet_" + name + ".png").c_str());
      PasteJoints& dialog =
          paste("Dip;Dip dir;Set;X;Y;Z;Trace [m]\n45,5°;120°;J1;1;2;3;12\n80;300;J2;4;5;6;\n95;20;J2;;;;\n");
      EXPECT_TRUE(QRect(QPoint(0, 0), size).contains(dialog.rect()));
      keepPicture(dialog, ("paste_" + name + ".png").c_str());
      dialog.close();
    }
  session->display.setDark(false);
}

TEST_F(StereonetWindow, FollowsChangesOfTheProject) {
  StereonetPanel& net = panel();
  Project changed = project();
  changed.cuts.push_back(changed.cuts[2]);
  session->project.document().change(changed, QStringLiteral("one more"));
  EXPECT_EQ(cell(table(net, "sets"), 1, 1), "2");
  session->project.document().undoStack().undo();
  EXPECT_EQ(cell(table(net, "sets"), 1, 1), "1");
}

TEST_F(StereonetWindow, JointsArePastedAsOneStepThatCanBeUndone) {
  PasteJoints& dialog = paste("dip\tdip direction\tset\tx\ty\tz\n45,5\t120\tC\t1\t2\t3\n30\t90\tA\t4\t5\t6\n");
  const PlainTable& preview = table(dialog, "preview");
  ASSERT_EQ(preview.rowCount(), 2);
  EXPECT_EQ(cell(preview, 0, 2), "45.5");
  EXPECT_EQ(cell(preview, 0, 4), "C");
  const Project before = project();
  click(*dialog.findChild<QPushButton*>(QStringLiteral("add")));
  EXPECT_FALSE(dialog.isVisible());
  ASSERT_EQ(project().cuts.size(), 5u);
  EXPECT_EQ(project().cuts[3].dip, 45.5);
  EXPECT_EQ(project().cuts[3].through, Vec3(1, 2, 3));
  ASSERT_EQ(project().joints.size(), 3u);
  EXPECT_EQ(project().joints[2].name, "C");
  EXPECT_EQ(project().joints[2].friction_angle, 25) << "as the joint that is chosen: the first";
  EXPECT_EQ(cell(table(panel(), "sets"), 2, 0), "C");
  session->project.document().undoStack().undo();
  EXPECT_EQ(project(), before);
  session->project.document().undoStack().redo();
  EXPECT_EQ(project().cuts.size(), 5u);
}

TEST_F(StereonetWindow, ATableOfJointsIsDropped) {
  drop(write("survey.csv", "dip;dip direction;set;x;y;z\n30;90;A;4;5;6\n60;200;C;1;2;3\n"));
  auto* dialog = window->findChild<PasteJoints*>();
  ASSERT_TRUE(dialog && dialog->isVisible());
  ASSERT_EQ(table(*dialog, "preview").rowCount(), 2);
  click(*dialog->findChild<QPushButton*>(QStringLiteral("add")));
  ASSERT_EQ(project().cuts.size(), 5u);
  EXPECT_EQ(project().cuts[4].joint, "C");
  EXPECT_EQ(project().cuts[4].dip, 60);
}

TEST_F(StereonetWindow, WhatIsWrongInATableIsToldLineByLine) {
  PasteJoints& dialog = paste("dip,dip direction,set\n45,120,J\n95,120,J\nsteep,1,J\n");
  const PlainTable& preview = table(dialog, "preview");
  ASSERT_EQ(preview.rowCount(), 3);
  EXPECT_EQ(cell(preview, 1, 0), "3");
  EXPECT_NE(cell(preview, 1, 1).find("dip: 95 is out of range"), std::string::npos) << cell(preview, 1, 1);
  auto& add = *dialog.findChild<QPushButton*>(QStringLiteral("add"));
  EXPECT_EQ(add.text().toStdString(), "Add 1 joint, leave 2 lines out");
  rest(50);
  keepPicture(dialog, "paste_faulty.png");
  auto& text = *dialog.findChild<QPlainTextEdit*>(QStringLiteral("text"));
  text.setFocus();
  text.selectAll();
  QTest::keyClicks(&text, QStringLiteral("nothing of the kind"));
  EXPECT_FALSE(add.isEnabled());
  EXPECT_NE(said(dialog, "notes").find("no columns of dip"), std::string::npos) << said(dialog, "notes");
}

TEST_F(StereonetWindow, SpacingsOfATableOfSetsMakeParallelPlanesThroughTheRock) {
  PasteJoints& dialog = paste("dip,dip direction,set,spacing\n0,0,B,2\n90,90,J,4\n");
  auto& spaced = *dialog.findChild<QComboBox*>(QStringLiteral("spaced"));
  EXPECT_EQ(spaced.currentIndex(), 0) << "one line a set";
  EXPECT_NE(said(dialog, "notes").find("8 planes in the rock"), std::string::npos) << said(dialog, "notes");
  dialog.setText(QStringLiteral("dip,dip direction,set,spacing\n0,0,B,2\n1,0,B,2\n"));
  EXPECT_EQ(spaced.currentIndex(), 1) << "a survey says where each one is";
  EXPECT_NE(said(dialog, "notes").find("not used"), std::string::npos) << said(dialog, "notes");
  dialog.setText(QStringLiteral("dip,dip direction,set,spacing\n0,0,B,2\n90,90,J,4\n"));
  click(*dialog.findChild<QPushButton*>(QStringLiteral("add")));
  ASSERT_EQ(project().cuts.size(), 5u);
  EXPECT_EQ(project().cuts[3].count, 5);
  EXPECT_EQ(project().cuts[3].spacing, 2);
  EXPECT_EQ(project().cuts[4].count, 3);
}

TEST_F(StereonetWindow, AllCountsAreSeenOnASmallScreen) {
  window->resize(1280, 720);
  rest(30);
  StereonetPanel& net = panel();
  type(net, "Face dip", "65");
  type(net, "Face dip direction", "140");
  rest(50);
  auto& counts = table(net, "counts");
  ASSERT_EQ(counts.rowCount(), 8);
  const QRect last = counts.visualItemRect(counts.item(7, 0));
  EXPECT_TRUE(counts.visibleRegion().contains(last)) << "the last row is seen without scrolling";
}

TEST_F(StereonetWindow, JointsWithoutAPlaceGoThroughTheOneThatIsTyped) {
  PasteJoints& dialog = paste("45 120 J\n");
  type(dialog, "Place z", "8");
  click(*dialog.findChild<QPushButton*>(QStringLiteral("add")));
  ASSERT_EQ(project().cuts.size(), 4u);
  EXPECT_EQ(project().cuts[3].through, Vec3(5, 5, 8)) << "the middle of the rock, but for what was typed";
}

TEST_F(StereonetWindow, JointsWithoutAPlaceGoThroughTheMiddleOfRockFromAFile) {
  window->open(sample("step_slope"));
  ASSERT_TRUE(wait([&] { return session->surfaces.current() && !session->surfaces.isBusy(); }));
  click(*paste("45 120 J\n").findChild<QPushButton*>(QStringLiteral("add")));
  EXPECT_LT((project().cuts.back().through - Vec3(80, 60, 50)).norm(), 1e-6);
}

/// The lightest band in the light and the darkest in the dark lie beside the paper, and in the legend on it.
TEST(StereonetBands, AreToldFromThePaperAndFromEachOther) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    QColor before = colourOf(colours(theme).surface);
    for (std::size_t band = 0; band < 6; ++band) {
      const QColor colour = colourOf(band_colour(band, 6, theme));
      EXPECT_GE(contrastRatio(colour, before), band == 0 ? 1.4 : 1.1) << band;
      before = colour;
    }
  }
}

}  // namespace
}  // namespace talus
