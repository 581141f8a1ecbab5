// The pages Blocks and Mesh, by clicks and keys.
#include <gmock/gmock.h>

#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "mesh/mesh_survey.hpp"
#include "removability/block_rule.hpp"
#include "widgets/blocks/block_table.hpp"
#include "widgets/blocks/mesh_panel.hpp"
#include "widgets/blocks/quality_chart.hpp"
#include "widgets/blocks/rule_dialog.hpp"
#include "widgets/kit/plain_table.hpp"
#include "widgets/view/render_surface.hpp"

namespace talus {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// A box of `across` × `across` × `across` cubes of 1 m, cut by bedding and two upright sets, on a fixed slab.
std::string cubes(int across) {
  const std::string count = std::to_string(across - 1), side = std::to_string(across);
  const auto set = [&](const char* joint, int dip, int direction, const char* through) {
    return std::string(R"({"joint": ")") + joint + R"(", "dip": )" + std::to_string(dip) + R"(, "dip_direction": )" +
           std::to_string(direction) + R"(, "through": )" + through + R"(, "spacing": 1, "count": )" + count +
           R"(, "solids": ["rock"]})";
  };
  return R"({
  "talus": 1, "name": "Cubes",
  "materials": {"granite": {"density": 2600, "young": 25e9, "poisson": 0.24},
                "marl": {"density": 2300, "young": 5e9, "poisson": 0.3}},
  "joints": {"bedding": {"friction_angle": 30}, "cross": {"friction_angle": 35}}, "default_joint": "bedding",
  "solids": [{"name": "rock", "material": "granite", "body": "rigid", "box": {"min": [0, 0, 0], "max": [)" +
         side + ", " + side + ", " + side + R"(]}},
             {"name": "ground", "material": "granite", "body": "fixed", "mesh_size": 5,
              "box": {"min": [0, 0, -1], "max": [)" +
         side + ", " + side + R"(, 0]}}],
  "cuts": [)" +
         set("bedding", 0, 0, "[0, 0, 1]") + ",\n           " + set("cross", 90, 90, "[1, 0, 0]") + ",\n           " +
         set("cross", 90, 0, "[0, 1, 0]") + R"(],
  "stages": [{"name": "go", "type": "dynamic", "time_step": 0.01, "steps": 1}]
})";
}

class BlocksPage : public DrivenWindow {
 protected:
  void cut(int across) {
    openAndMesh(write("cubes.talus", cubes(across)));
    session->display.goTo(WorkflowPage::blocks);
    ASSERT_TRUE(wait([&] { return session->survey.facts() != nullptr; }));
    rest(30);
  }
  template <class Widget>
  Widget& named(const char* name) {
    auto* found = window->findChild<Widget*>(QLatin1String(name));
    EXPECT_NE(found, nullptr) << name;
    return *found;
  }
  BlockTable& table() { return named<BlockTable>("blocks"); }
  QString cell(int row, int column) { return table().model()->index(row, column).data().toString(); }
  int columnOf(const char* title) {
    for (int c = 0; c < table().model()->columnCount(); ++c)
      if (table().model()->headerData(c, Qt::Horizontal).toString() == QString::fromUtf8(title)) return c;
    ADD_FAILURE() << "no column " << title;
    return 0;
  }
  void clickHead(const char* title) {
    auto* head = table().horizontalHeader();
    const int column = columnOf(title);
    QTest::mouseClick(head->viewport(), Qt::LeftButton, {},
                      {head->sectionViewportPosition(column) + head->sectionSize(column) / 2, head->height() / 2});
  }
  RuleDialog& rule() {
    QTest::keyClick(window.get(), Qt::Key_F, Qt::ControlModifier);
    rest(30);
    auto* dialog = window->findChild<RuleDialog*>();
    EXPECT_NE(dialog, nullptr);
    return *dialog;
  }
  template <class Widget>
  static Widget& in(QWidget& dialog, const char* name) {
    return *dialog.findChild<Widget*>(QLatin1String(name));
  }
  static void choose(QComboBox& box, const char* entry) {
    const int index = box.findText(QString::fromUtf8(entry));
    ASSERT_GE(index, 0) << entry;
    box.setCurrentIndex(index);
    emit box.activated(index);
  }
  static void type(QLineEdit& field, const char* words, Qt::Key last = Qt::Key_Return) {
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, QString::fromUtf8(words));
    QTest::keyClick(&field, last);
  }
  /// Selects what lies below a level by the dialog.
  void selectBelow(const char* level) {
    RuleDialog& dialog = rule();
    choose(in<QComboBox>(dialog, "question"), "below a plane");
    type(in<QLineEdit>(dialog, "number"), level);  // Enter selects
    dialog.close();
    window->activateWindow();
    rest(20);
  }
  const std::vector<int>& selected() { return session->project.selection().blocks(); }
  std::vector<std::string> selectedNames() {
    std::vector<std::string> names;
    for (const int block : selected()) names.push_back(session->project.blockName(block).toStdString());
    return names;
  }
  const Project& project() { return session->project.document().project(); }
  QUndoStack& undoStack() { return session->project.document().undoStack(); }
};

TEST_F(BlocksPage, TableTellsOfEachBlockAndSortsNumbersAsNumbers) {
  cut(3);
  EXPECT_EQ(table().model()->rowCount(), 28);
  EXPECT_EQ(cell(0, 0), QStringLiteral("ground"));
  EXPECT_EQ(cell(2, 0), QStringLiteral("rock.2"));
  EXPECT_EQ(cell(10, 0), QStringLiteral("rock.10")) << "10 stands after 9";
  clickHead("Volume m³");
  EXPECT_EQ(cell(27, 0), QStringLiteral("ground"));
  clickHead("Neighbours");
  EXPECT_EQ(cell(0, columnOf("Neighbours")), QStringLiteral("3")) << "the corners above";
  EXPECT_EQ(cell(27, columnOf("Neighbours")), QStringLiteral("9")) << "the ground";
  EXPECT_EQ(cell(26, columnOf("Neighbours")), QStringLiteral("6")) << "in the middle";
  EXPECT_EQ(cell(26, columnOf("Leaves")), QStringLiteral("enclosed"));
  keepPicture(*window, "blocks_page.png");
}

TEST_F(BlocksPage, SelectionIsSharedWithTheTable) {
  cut(2);
  QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, table().visualRect(table().model()->index(1, 0)).center());
  QTest::mouseClick(table().viewport(), Qt::LeftButton, Qt::ControlModifier,
                    table().visualRect(table().model()->index(2, 0)).center());
  EXPECT_THAT(selectedNames(), ElementsAre("rock.1", "rock.2"));
  session->project.selection().selectBlocks({3, 4, 5});
  EXPECT_THAT(table().selectionModel()->selectedRows(), SizeIs(3));
  QTest::keyClick(window.get(), Qt::Key_I, Qt::ControlModifier);
  EXPECT_THAT(selected(), SizeIs(6));
  QTest::keyClick(window.get(), Qt::Key_A, Qt::ControlModifier);
  EXPECT_THAT(selected(), SizeIs(9));
  session->project.selection().selectBlocks({0});
  QTest::keyClick(window.get(), Qt::Key_G, Qt::ControlModifier);
  EXPECT_THAT(selected(), SizeIs(5)) << "a corner has three neighbours, and the ground";
}

TEST_F(BlocksPage, FilterShowsTheRowsThatHaveItsWordsAndKeepsTheSelection) {
  cut(3);
  session->project.selection().selectBlocks({0, 5});
  auto* box = table().parentWidget()->findChild<QLineEdit*>();
  ASSERT_NE(box, nullptr);
  box->setFocus();
  QTest::keyClicks(box, QStringLiteral("enclosed"));
  EXPECT_EQ(table().shownRows(), 2) << "in the middle, and the one below it";
  EXPECT_THAT(selected(), SizeIs(2));
  box->clear();
  EXPECT_EQ(table().shownRows(), 28);
  EXPECT_THAT(table().selectionModel()->selectedRows(), SizeIs(2));
}

TEST_F(BlocksPage, RuleSaysHowManyItMeansAndCombines) {
  cut(3);
  RuleDialog& dialog = rule();
  auto& question = in<QComboBox>(dialog, "question");
  choose(question, "above a plane");
  type(in<QLineEdit>(dialog, "number"), "2", Qt::Key_Tab);
  EXPECT_EQ(in<QLabel>(dialog, "count").text(), QStringLiteral("9 of 28 blocks"));
  EXPECT_THAT(selected(), IsEmpty()) << "it is said before it is done";
  click(in<QPushButton>(dialog, "select"));
  EXPECT_THAT(selected(), SizeIs(9));
  choose(question, "volume above");
  choose(in<QComboBox>(dialog, "how"), "part of the selection");
  type(in<QLineEdit>(dialog, "number"), "5 m3", Qt::Key_Tab);
  click(in<QPushButton>(dialog, "select"));
  EXPECT_THAT(selected(), SizeIs(10)) << "and the ground";
  choose(question, "body");
  choose(in<QComboBox>(dialog, "which"), "rigid");
  choose(in<QComboBox>(dialog, "how"), "all that stays of it");
  EXPECT_EQ(in<QLabel>(dialog, "count").text(), QStringLiteral("9 of 28 blocks"));
  rest(30);
  keepPicture(dialog, "rule_dialog.png");
}

TEST_F(BlocksPage, BlocksSelectedByRuleAreExcavatedInOneStepAndBroughtBack) {
  cut(2);
  selectBelow("0.7 m");
  EXPECT_THAT(selectedNames(), SizeIs(5));
  session->project.selection().toggleBlock(8);  // not the ground
  ASSERT_THAT(selected(), SizeIs(4));
  const int steps = undoStack().count();
  QTest::keyClick(window.get(), Qt::Key_Delete);
  EXPECT_EQ(undoStack().count(), steps + 1);
  EXPECT_EQ(undoStack().undoText(), QStringLiteral("excavate 4 blocks"));
  EXPECT_EQ(project().blocks.size(), 4u);
  for (const BlockOverride& block : project().blocks) {
    EXPECT_TRUE(block.removed);
    EXPECT_LT(block.at.z(), 1);
    EXPECT_GT(block.at.z(), 0);
  }
  auto& list = named<QToolButton>("excavated");
  EXPECT_EQ(list.text().trimmed(), QStringLiteral("4 excavated"));
  list.menu()->actions().back()->trigger();
  EXPECT_EQ(undoStack().undoText(), QStringLiteral("bring back 1 block"));
  EXPECT_EQ(list.text().trimmed(), QStringLiteral("3 excavated"));
  undoStack().undo();
  undoStack().undo();
  EXPECT_TRUE(project().blocks.empty());
  EXPECT_FALSE(list.isVisible());
}

TEST_F(BlocksPage, SeveralAreNamedByPatternAndGivenBodyMaterialAndMeshSize) {
  cut(2);
  session->project.selection().selectBlocks({0, 1, 2});
  rest(20);
  type(named<QLineEdit>("names"), "roof {n}");
  rest(20);
  ASSERT_EQ(project().blocks.size(), 3u);
  EXPECT_EQ(project().blocks[2].name, "roof 3");
  EXPECT_EQ(undoStack().undoText(), QStringLiteral("name 3 blocks"));
  choose(named<QComboBox>("body"), "affine");
  rest(20);
  EXPECT_EQ(named<QComboBox>("body").currentText(), QStringLiteral("affine")) << "what they will be is shown";
  choose(named<QComboBox>("material"), "marl");
  rest(20);
  type(named<QLineEdit>("mesh_size"), "25 cm");
  rest(20);
  for (const BlockOverride& block : project().blocks) {
    EXPECT_EQ(block.body, BodyKind::affine);
    EXPECT_EQ(block.material, "marl");
    EXPECT_EQ(block.mesh_size, 0.25);
  }
  EXPECT_EQ(undoStack().count(), 4);
  for (int i = 0; i < 4; ++i) undoStack().undo();
  EXPECT_TRUE(project().blocks.empty());
}

TEST_F(BlocksPage, WithoutANumberInThePatternSeveralBlocksKeepTheirNames) {
  cut(2);
  session->project.selection().selectBlocks({0, 1});
  rest(20);
  type(named<QLineEdit>("names"), "roof");
  EXPECT_TRUE(project().blocks.empty());
  ASSERT_FALSE(session->messages.problems().empty());
  EXPECT_TRUE(session->messages.problems().back().remedy.contains(QStringLiteral("{n}")));
}

TEST_F(BlocksPage, BlocksThatTouchAreMergedByPointsInThem) {
  cut(2);
  session->project.selection().selectBlocks({0, 1, 3});
  QTest::keyClick(window.get(), Qt::Key_M);
  ASSERT_EQ(project().merges.size(), 2u);
  const auto holds = [&](int block, const Vec3& point) {
    Vec3 low = Vec3::Constant(1e9), high = -low;
    for (const Vec3& node : session->project.system()->blocks[static_cast<std::size_t>(block)].mesh.nodes) {
      low = low.cwiseMin(node);
      high = high.cwiseMax(node);
    }
    return (point.array() > low.array()).all() && (point.array() < high.array()).all();
  };
  EXPECT_TRUE(holds(0, project().merges[0].at));
  EXPECT_TRUE(holds(1, project().merges[0].with));
  EXPECT_TRUE(holds(3, project().merges[1].with));
  session->project.selection().selectBlocks({0, 7});
  QTest::keyClick(window.get(), Qt::Key_M);
  EXPECT_EQ(project().merges.size(), 2u) << "they do not touch";
  EXPECT_FALSE(session->messages.problems().empty());
}

/// Cutting would refuse the project for it: better before it is written there.
TEST_F(BlocksPage, BlocksOfTwoSolidsAreNotMergedAndItSaysWhatToDo) {
  cut(2);
  const auto& blocks = session->project.system()->blocks;
  const auto other = std::ranges::find_if(blocks, [&](const Block& block) { return block.solid != blocks[0].solid; });
  ASSERT_NE(other, blocks.end());
  for (int block = 0; block < 8; ++block) {
    session->project.selection().selectBlocks({block, static_cast<int>(other - blocks.begin())});
    QTest::keyClick(window.get(), Qt::Key_M);
  }
  EXPECT_TRUE(project().merges.empty());
  EXPECT_TRUE(std::ranges::any_of(session->messages.problems(), [](const Problem& told) {
    return told.remedy.contains(QStringLiteral("unite the two solids"));
  }));
}

TEST_F(BlocksPage, LassoSelectsWhatItGoesAround) {
  cut(2);
  QWidget* area = nullptr;
  for (auto* one : window->viewport().findChildren<QWidget*>())
    if (one->accessibleName() == QStringLiteral("3-D view")) area = one;
  ASSERT_NE(area, nullptr);
  const auto drag = [&](const std::vector<QPoint>& way) {
    QTest::mousePress(area, Qt::LeftButton, Qt::AltModifier, way.front());
    for (const QPoint& at : way) {
      QMouseEvent move(QEvent::MouseMove, at, area->mapToGlobal(at), Qt::LeftButton, Qt::LeftButton, Qt::AltModifier);
      QApplication::sendEvent(area, &move);
    }
    QTest::mouseRelease(area, Qt::LeftButton, Qt::AltModifier, way.back());
  };
  const int right = area->width() - 2, bottom = area->height() - 2;
  drag({{2, 2}, {right, 2}, {right, bottom}, {2, bottom}});
  EXPECT_THAT(selected(), SizeIs(9)) << "around all";
  drag({{2, 2}, {40, 2}, {40, 40}, {2, 40}});
  EXPECT_THAT(selected(), IsEmpty()) << "around nothing";
}

TEST_F(BlocksPage, ColoursAndDistanceAreChosenInTheBar) {
  cut(2);
  choose(named<QComboBox>("colour by"), "Removability");
  ASSERT_NE(session->display.settings().block_colours, nullptr);
  EXPECT_EQ(session->display.settings().block_colours->colours.size(), 9u);
  EXPECT_EQ(session->display.settings().block_colours->key.front().meaning, "fixed");
  session->project.selection().selectBlocks({1, 3});
  rest(500);
  keepPicture(*window, "removability.png");
  choose(named<QComboBox>("colour by"), "Block");
  EXPECT_EQ(session->display.settings().block_colours, nullptr);
  const CameraPose together = *window->viewport().pose();
  const auto distance = [](const CameraPose& pose) { return (pose.position - pose.focal_point).norm(); };
  named<QSlider>("apart").setValue(20);
  EXPECT_EQ(session->display.settings().explosion, 1);
  EXPECT_GT(distance(*window->viewport().pose()), 1.2 * distance(together)) << "all of them stay in view";
  QTest::keyClick(window.get(), Qt::Key_E);
  EXPECT_EQ(session->display.settings().explosion, 0);
  EXPECT_EQ(named<QSlider>("apart").value(), 0);
  EXPECT_EQ(distance(*window->viewport().pose()), distance(together));
}

TEST_F(BlocksPage, HistogramCountsEveryTetrahedronOnceAndTheWorstAreShownInTheView) {
  cut(2);
  session->display.goTo(WorkflowPage::mesh);
  rest(30);
  long tetrahedra = 0, of_corners = 0;
  for (const Block& block : session->project.system()->blocks)
    (block.stands_on_corners ? of_corners : tetrahedra) += static_cast<long>(block.mesh.tetrahedra.size());
  EXPECT_EQ(of_corners, 8 * 12) << "the rigid cubes, which are not rated";
  auto* chart = window->findChild<QualityChart*>();
  EXPECT_EQ(chart->count(), tetrahedra);
  choose(named<QComboBox>("measure"), "Smallest angle");
  EXPECT_EQ(chart->count(), tetrahedra);
  auto& worst = named<PlainTable>("worst");
  QTest::mouseClick(worst.viewport(), Qt::LeftButton, {}, worst.visualItemRect(worst.item(0, 0)).center());
  ASSERT_THAT(session->display.settings().places, SizeIs(1));
  EXPECT_TRUE(window->viewport().isFlying());
  EXPECT_THAT(selected(), SizeIs(1));
  EXPECT_TRUE(wait([&] { return !window->viewport().isFlying(); }));
  rest(400);
  keepPicture(*window, "mesh_page.png");
  session->display.goTo(WorkflowPage::blocks);
  EXPECT_THAT(session->display.settings().places, IsEmpty());
}

TEST_F(BlocksPage, QualityOfTheMeshIsReadWithoutScrollingOnASmallScreen) {
  cut(2);
  window->resize(1280, 720);
  session->display.goTo(WorkflowPage::mesh);
  rest(50);
  const auto& table = named<BlockTable>("mesh");
  constexpr int mean = 4;  // after block, tetrahedra, worst and angle
  ASSERT_EQ(table.model()->headerData(mean, Qt::Horizontal).toString(), QStringLiteral("Mean"));
  EXPECT_LE(table.columnViewportPosition(mean) + table.columnWidth(mean), table.viewport()->width());
}

TEST_F(BlocksPage, MeshIsRefinedNearAPlaceAndWhatItWillComeToIsTold) {
  cut(2);
  session->display.goTo(WorkflowPage::mesh);
  rest(30);
  auto& ahead = named<QLabel>("ahead");
  EXPECT_TRUE(ahead.text().isEmpty());
  QTest::mouseClick(&named<QToolButton>("refine"), Qt::LeftButton);
  ASSERT_TRUE(session->picking.isAsking());
  session->picking.take({.block = 8, .point = Vec3(1, 1, -1)});
  ASSERT_THAT(project().mesh.refinements, SizeIs(1));
  EXPECT_EQ(project().mesh.refinements[0].at, Vec3(1, 1, -1));
  EXPECT_EQ(undoStack().undoText(), QStringLiteral("refine the mesh near a place"));
  EXPECT_TRUE(ahead.text().startsWith(QStringLiteral("Meshed anew: about "))) << ahead.text().toStdString();
  Project tooFine = project();
  tooFine.solids[1].mesh_size = 0.01;
  tooFine.mesh.refinements.clear();  // near the place it would be coarser than that
  tooFine.mesh.most_tetrahedra = 1000;
  session->project.document().change(tooFine, QStringLiteral("too fine"));
  EXPECT_TRUE(ahead.text().contains(QStringLiteral("more than the 1000"))) << ahead.text().toStdString();
  undoStack().undo();
  undoStack().undo();
  EXPECT_TRUE(ahead.text().isEmpty());
}

// What the threads that draw in software take is the machine's; the window's own thread must stay free.
TEST_F(BlocksPage, NoEventWaitsATenthOfASecondWithAThousandBlocks) {
  warmUp();
  const double arriving = calmestWork([&] { cut(10); });
  ASSERT_EQ(session->project.system()->blocks.size(), 1001u);
  const double selecting = calmestWork([&] {
    for (const int key : {Qt::Key_A, Qt::Key_I, Qt::Key_A}) {
      QTest::keyClick(window.get(), static_cast<Qt::Key>(key), Qt::ControlModifier);
      rest(50);
    }
    session->project.selection().selectBlocks({5, 6, 7});
    rest(50);
    QTest::keyClick(window.get(), Qt::Key_G, Qt::ControlModifier);
    rest(400);  // it is drawn finely as well
  });
  const double sorting = calmestWork([&] {
    for (const char* head : {"Volume m³", "F", "Leaves", "Block"}) {
      clickHead(head);
      rest(50);
    }
  });
  const double turning = calmestWork([&] {
    for (const WorkflowPage page : {WorkflowPage::mesh, WorkflowPage::blocks}) {
      session->display.goTo(page);
      rest(400);
    }
  });
  std::printf("arriving %.1f ms, selecting %.1f ms, sorting %.1f ms, changing pages %.1f ms\n", arriving, selecting,
              sorting, turning);
  EXPECT_LT(std::max({arriving, selecting, sorting, turning}), 100);
}

TEST_F(BlocksPage, AThousandBlocksAreExcavatedAndNamedWithoutHoldingTheWindowUp) {
  warmUp();
  cut(10);
  session->project.selection().selectBlocks(inverted({1000}, 1001));
  rest(400);
  const RenderSurface& surface = window->viewport().surface();
  const int drawn = surface.drawings();
  const double excavating = calmestWork([&] {
    QTest::keyClick(window.get(), Qt::Key_Delete);
    rest(400);
    EXPECT_EQ(project().blocks.size(), 1000u);
    undoStack().undo();
    rest(400);
  });
  EXPECT_EQ(surface.drawings(), drawn) << "the view shows nothing of it before they are cut anew";
  const double naming = calmestWork([&] {
    type(named<QLineEdit>("names"), "roof {n}");
    rest(400);
    EXPECT_EQ(project().blocks.size(), 1000u);
    undoStack().undo();
    rest(400);
  });
  std::printf("excavating %.1f ms, naming %.1f ms\n", excavating, naming);
  EXPECT_LT(std::max(excavating, naming), 100);
}

}  // namespace
}  // namespace talus
