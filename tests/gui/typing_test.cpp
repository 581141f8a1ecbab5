// Keys and selection: what is typed into a field is the field's, cutting can be cancelled, several selected show all.
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTest>
#include <fstream>
#include <map>
#include <memory>
#include <set>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "widgets/kit/number_field.hpp"
#include "widgets/kit/parts.hpp"
#include "widgets/kit/theme.hpp"
#include "widgets/run/run_panel.hpp"
#include "widgets/setup/property_panel.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/window/rail.hpp"

namespace talus {
namespace {

class Typing : public DrivenWindow {
 protected:
  NumberField* field(const char* name) {
    for (auto* one : window->findChildren<NumberField*>())
      if (one->accessibleName() == QString::fromUtf8(name)) return one;
    return nullptr;
  }
  /// Programs that cut for this one: forked by the mesher that waits for its jobs.
  static std::set<int> meshers() {
    std::set<int> waiting;
    std::map<int, int> parents;  // of all meshers that have not ended
    std::error_code gone;
    for (const auto& entry : std::filesystem::directory_iterator("/proc", gone)) {
      std::ifstream status(entry.path() / "stat");
      int process = 0, parent = 0;
      std::string name, state;
      if (!(status >> process >> name >> state >> parent) || name.find("talus-mesher") != 1 || state == "Z") continue;
      parents[process] = parent;
      if (parent == ::getpid()) waiting.insert(process);
    }
    std::set<int> found;
    for (const auto& [process, parent] : parents)
      if (waiting.contains(parent)) found.insert(process);
    return found;
  }
  /// Fine enough to keep the mesher busy for long.
  std::filesystem::path fineSlab() {
    return write("fine.talus", R"({
      "talus": 1, "name": "Fine slab", "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.25}},
      "solids": [{"name": "base", "box": {"min": [0, 0, 0], "max": [40, 4, 1]}, "material": "rock", "mesh_size": 0.1}],
      "stages": [{"name": "wait", "type": "static", "time_step": 0.01, "steps": 2}]})");
  }
};

TEST_F(Typing, UndoAfterATitleWasTypedIsTheProjects) {
  window->open(slidingCube(40));
  window->activateWindow();
  session->project.selection().select({});
  rest(30);
  const auto title = [&] {
    for (auto* one : window->findChildren<QLineEdit*>())
      if (one->accessibleName() == QStringLiteral("Title") && one->isVisible()) return one;
    throw std::runtime_error("no field of the title");
  };
  title()->setFocus();
  title()->selectAll();
  QTest::keyClicks(title(), QStringLiteral("Quarry"));
  QTest::keyClick(title(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(session->project.document().undoStack().count(), 0) << "what is typed is the field's until it is entered";
  title()->selectAll();
  QTest::keyClicks(title(), QStringLiteral("Quarry"));
  QTest::keyClick(title(), Qt::Key_Return);
  EXPECT_EQ(session->project.document().name(), QStringLiteral("Quarry"));
  rest(30);
  title()->setFocus();
  QTest::keyClick(title(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(session->project.document().name(), QStringLiteral("Sliding cube"));
  rest(30);
  title()->setFocus();
  QTest::keyClick(title(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(session->project.document().name(), QStringLiteral("Quarry"));
}

TEST_F(Typing, EscapeAndDigitsInAFieldAreTheFields) {
  openAndMesh(slidingCube(40));
  window->activateWindow();
  session->project.selection().select({Item::Kind::joint, 0});
  NumberField* angle = field("Friction angle φ");
  ASSERT_NE(angle, nullptr);
  angle->setFocus();
  rest(20);
  const CameraPose before = *window->viewport().pose();
  QTest::keyClicks(angle, QStringLiteral("3175"));
  EXPECT_EQ(angle->text(), QStringLiteral("3175"));
  EXPECT_EQ((window->viewport().pose()->position - before.position).norm(), 0) << "1, 3 and 7 turn the view elsewhere";
  EXPECT_EQ(window->viewport().pose()->parallel, before.parallel);
  QTest::keyClick(angle, Qt::Key_Escape);
  EXPECT_EQ(session->project.selection().current(), (Item{Item::Kind::joint, 0})) << "it is not the selection's";
  ASSERT_EQ(field("Friction angle φ"), angle);
  EXPECT_TRUE(angle->text().startsWith(QStringLiteral("10"))) << "but takes back what was typed";
  QTest::keyClick(angle, Qt::Key_Home);
  EXPECT_EQ((window->viewport().pose()->position - before.position).norm(), 0);

  auto* area = const_cast<RenderSurface&>(window->viewport().surface()).widget();
  area->setFocus();
  QTest::keyClick(area, Qt::Key_1);
  EXPECT_GT((window->viewport().pose()->position - before.position).norm(), 0) << "in the view they are the view's";
}

/// A field's number is selected when one comes to it, which is a moment later: one may have gone on by then.
TEST_F(Typing, OnlyTheFieldThatIsTypedIntoIsSelected) {
  window->open(slidingCube(40));
  session->project.selection().select({Item::Kind::joint, 0});
  rest(50);
  auto* first = field("Friction angle φ");
  auto* second = field("Cohesion c");
  ASSERT_TRUE(first && second);
  first->setFocus();
  second->setFocus();
  rest(20);
  EXPECT_FALSE(first->hasSelectedText());
  first->setFocus();
  rest(20);
  EXPECT_TRUE(first->hasSelectedText());
}

TEST_F(Typing, ANumberIsRoundedBeforeItsUnitIsCutOffAndTypedOverWhole) {
  window->open(slidingCube(40));
  Project changed = session->project.document().project();
  changed.solids[1].mesh_size = 1.0 / 3;
  session->project.document().change(changed, QStringLiteral("a third"));
  session->project.selection().select({Item::Kind::solid, 1});
  rest(50);
  NumberField* size = field("Mesh size");
  ASSERT_TRUE(size && size->isVisible());
  size->setFixedWidth(80);
  rest(20);
  EXPECT_TRUE(size->text().startsWith(QStringLiteral("0.333"))) << size->text().toStdString();
  EXPECT_TRUE(size->text().endsWith(QStringLiteral(" m"))) << size->text().toStdString();
  EXPECT_LT(size->fontMetrics().horizontalAdvance(size->text()), size->width());
  EXPECT_TRUE(size->toolTip().startsWith(QStringLiteral("0.333333333333 m"))) << size->toolTip().toStdString();
  window->activateWindow();
  size->setFocus();
  rest(20);
  EXPECT_EQ(size->text(), QStringLiteral("0.333333333333 m")) << "who types sees all of it";
  QTest::keyClick(size, Qt::Key_Tab);
  rest(20);
  EXPECT_EQ(session->project.document().project().solids[1].mesh_size, 1.0 / 3) << "looking at it changes nothing";
}

TEST_F(Typing, CuttingIsCancelledAndBegunAgain) {
  window->open(fineSlab());
  session->run.mesh();
  ASSERT_TRUE(wait([&] { return !meshers().empty(); }));
  rest(300);
  keepPicture(*window, "cutting.png");
  QPushButton* cancel = nullptr;
  for (auto* one : window->viewport().findChildren<QPushButton*>())
    if (one->isVisible() && one->text() == QStringLiteral("Cancel")) cancel = one;
  ASSERT_NE(cancel, nullptr);
  EXPECT_EQ(window->findChild<QPushButton*>(QStringLiteral("primary"))->text(), QStringLiteral("Cancel"));
  click(*cancel);
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }, 3000));
  EXPECT_TRUE(meshers().empty());
  EXPECT_EQ(session->project.system(), nullptr) << "nothing half-made";
  EXPECT_TRUE(session->messages.problems().empty());
  Project coarse = session->project.document().project();
  coarse.solids[0].mesh_size = 2;
  session->project.document().change(coarse, QStringLiteral("coarser"));
  session->run.mesh();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }));
  ASSERT_NE(session->project.system(), nullptr);
}

TEST_F(Typing, TheBlocksFromBeforeAreThereAgainWhenCuttingIsCancelled) {
  openAndMesh(slidingCube(40));
  const auto before = session->project.system();
  Project fine = session->project.document().project();
  fine.solids[0].mesh_size = 0.1;
  session->project.document().change(fine, QStringLiteral("finer"));
  session->run.mesh();
  ASSERT_TRUE(wait([&] { return !meshers().empty(); }));
  session->run.job().stop();
  ASSERT_TRUE(wait([&] { return !session->run.job().isBusy(); }, 3000));
  EXPECT_EQ(session->project.system(), before);
  EXPECT_FALSE(session->project.systemIsCurrent());
  session->project.document().undoStack().undo();
  EXPECT_TRUE(session->project.systemIsCurrent());
}

TEST_F(Typing, SeveralSelectedBlocksAreToldOfTogether) {
  openAndMesh(slidingCube(40));
  session->project.selection().selectBlocks({0, 1});
  const auto* panel = window->findChild<PropertyPanel*>();
  QStringList words;
  for (const auto* label : panel->findChildren<QLabel*>()) words << label->text();
  EXPECT_TRUE(words.contains(QStringLiteral("2 blocks"))) << words.join(u'|').toStdString();
  EXPECT_TRUE(words.contains(QStringLiteral("168.00 m³"))) << words.join(u'|').toStdString();  // 40 · 4 · 1 + 2³
  EXPECT_TRUE(words.contains(QStringLiteral("base, cube")));
  rest(300);
  keepPicture(*window, "several_blocks.png");
}

TEST_F(Typing, ABoxDrawnWithShiftSelectsAndEDrawsTheBlocksApart) {
  openAndMesh(slidingCube(40));
  auto& view = window->viewport();
  auto* area = const_cast<RenderSurface&>(view.surface()).widget();
  const CameraPose before = *view.pose();
  const auto drag = [&](QPoint from, QPoint to) {
    QTest::mousePress(area, Qt::LeftButton, Qt::ShiftModifier, from);
    QMouseEvent move(QEvent::MouseMove, QPointF(to), area->mapToGlobal(QPointF(to)), Qt::NoButton, Qt::LeftButton,
                     Qt::ShiftModifier);
    QApplication::sendEvent(area, &move);
    QTest::mouseRelease(area, Qt::LeftButton, Qt::ShiftModifier, to);
  };
  const QPoint corner(view.width() - 2, view.height() - 2);
  drag({2, 2}, corner);
  EXPECT_EQ(session->project.selection().blocks(), (std::vector<int>{0, 1}));
  EXPECT_EQ((view.pose()->position - before.position).norm(), 0) << "it neither turns nor pans";
  // Round the cube alone: the base sticks out of the box.
  QRect cube;
  for (int y = 4; y < view.height(); y += 4)
    for (int x = 4; x < view.width(); x += 4)
      if (const auto pick = view.pickAt(QPointF(x, y)); pick && pick->block == 1) cube |= QRect(x, y, 1, 1);
  cube.adjust(-8, -8, 8, 8);
  drag(cube.topLeft(), cube.bottomRight());
  EXPECT_EQ(session->project.selection().blocks(), std::vector<int>{1}) << "to the right: what lies wholly in it";
  const auto lowest = [&](int block) {
    int row = 0;
    for (int y = 4; y < view.height(); y += 4)
      for (int x = 4; x < view.width(); x += 4)
        if (const auto pick = view.pickAt(QPointF(x, y)); pick && pick->block == block) row = y;
    return row;
  };
  rest(50);  // the panels make room for what is selected, and the view changes its height
  const int together = lowest(1);
  area->setFocus();
  QTest::keyClick(area, Qt::Key_E);
  rest(300);
  keepPicture(*window, "exploded.png");
  EXPECT_GT(session->display.settings().explosion, 0);
  EXPECT_NE(lowest(1), together);
  QTest::keyClick(area, Qt::Key_E);
  EXPECT_EQ(lowest(1), together);
}

TEST_F(Typing, XCutsWhatIsSelectedOpenAcrossTheViewAndClosesIt) {
  openAndMesh(slidingCube(40));
  session->display.goTo(WorkflowPage::blocks);
  session->project.selection().selectBlocks({1});
  rest(50);
  QWidget* area = const_cast<RenderSurface&>(window->viewport().surface()).widget();
  const QPixmap whole = window->viewport().picture();
  QTest::keyClick(area, Qt::Key_X);
  rest(300);
  const auto section = session->display.settings().section;
  ASSERT_TRUE(section);
  EXPECT_LT((section->point - Vec3(2, 2, 2)).norm(), 1e-9) << "the middle of the cube";
  EXPECT_EQ(section->towards.z(), 0) << "upright";
  EXPECT_NE(window->viewport().picture().toImage(), whole.toImage());
  QTest::keyClick(area, Qt::Key_X);
  EXPECT_FALSE(session->display.settings().section);
}

TEST_F(Typing, AWindowOpensInTheSizeThatIsAskedFor) {
  window->resize(1280, 800);
  window->close();  // keeps its size
  MainWindow other;
  other.present(QSize(1280, 720));
  rest(50);
  EXPECT_EQ(other.size(), QSize(1280, 720));
}

TEST_F(Typing, NoRowOfTheRunPanelIsPressedOverAnother) {
  window->resize(1280, 720);
  openAndMesh(write("dropped.talus", R"({
    "talus": 1, "name": "Dropped cube", "gravity": [0, 0, -9.81],
    "materials": {"rock": {"density": 2600, "young": 1e9, "poisson": 0.25}},
    "joints": {"J1": {"friction_angle": 30}}, "default_joint": "J1",
    "solids": [
      {"name": "base", "box": {"min": [0, 0, 0], "max": [8, 6, 1]}, "material": "rock", "body": "fixed", "mesh_size": 2},
      {"name": "cube", "box": {"min": [2, 2, 1.05], "max": [4, 4, 3.05]}, "material": "rock", "mesh_size": 1}],
    "solver": {"open_close_limit": 3},
    "stages": [{"name": "drop", "type": "dynamic", "time_step": 0.002, "steps": 100}],
    "output": {"every": 0.02}})"));
  session->solve();
  ASSERT_TRUE(wait([&] { return session->display.page() == WorkflowPage::results && session->playback.frame(); }));
  session->display.goTo(WorkflowPage::solve);
  rest(300);
  keepPicture(*window, "run_rows.png");
  auto* panel = window->findChild<RunPanel*>();
  std::vector<std::pair<QRect, const QLabel*>> shown;
  for (const auto* label : panel->findChildren<QLabel*>()) {
    if (!label->isVisible() || label->text().isEmpty()) continue;
    const int needed = label->wordWrap() ? label->heightForWidth(label->width()) : label->minimumSizeHint().height();
    EXPECT_GE(label->height(), needed) << label->text().toStdString();
    if (label->property("role") == QByteArray("display")) {
      EXPECT_GE(label->width(), label->sizeHint().width()) << label->text().toStdString();
    }
    const QRect place(label->mapTo(panel, QPoint(0, 0)), label->size());
    for (const auto& [other, words] : shown)
      EXPECT_FALSE(place.intersects(other)) << label->text().toStdString() << " over " << words->text().toStdString();
    shown.emplace_back(place, label);
  }
  EXPECT_GT(shown.size(), 20u);
}

/// The strongest contrast of a part of a picture with its ground.
double strongestIn(const QImage& picture, const QRect& part, const QColor& ground) {
  double most = 1;
  for (int y = part.top(); y <= part.bottom(); ++y)
    for (int x = part.left(); x <= part.right(); ++x)
      most = std::max(most, contrastRatio(picture.pixelColor(x, y), ground));
  return most;
}

TEST_F(Typing, ADisabledActionOfTheBarLooksDisabled) {
  for (const bool dark : {false, true}) {
    theme::install(dark);
    const std::unique_ptr<QWidget> bar(makePlane("surface"));
    auto* button = makeAction(QStringLiteral("cut"), QStringLiteral("MMMM"));
    (new QVBoxLayout(bar.get()))->addWidget(button);
    bar->show();
    const auto contrast = [&] {
      rest(30);
      const QImage picture = bar->grab().toImage();
      return strongestIn(picture, button->geometry(), picture.pixelColor(4, 4));
    };
    const double enabled = contrast();
    button->setEnabled(false);
    EXPECT_GT(enabled, 6);
    EXPECT_LT(contrast(), enabled / 2);
  }
  theme::install(false);
}

TEST_F(Typing, ADisabledMenuEntryLooksDisabled) {
  for (const bool dark : {false, true}) {
    theme::install(dark);
    QMenu menu;
    menu.addAction(QStringLiteral("MMMM"));
    menu.addAction(QStringLiteral("MMMM"))->setEnabled(false);
    menu.popup(QPoint(10, 10));
    rest(50);
    const QImage picture = menu.grab().toImage();
    const QColor ground = picture.pixelColor(picture.width() / 2, 3);
    EXPECT_GT(strongestIn(picture, menu.actionGeometry(menu.actions()[0]), ground), 6);
    EXPECT_LT(strongestIn(picture, menu.actionGeometry(menu.actions()[1]), ground), 3);
    menu.close();
  }
  theme::install(false);
}

}  // namespace
}  // namespace talus
