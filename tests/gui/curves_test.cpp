// A time table is drawn: its points are dragged, put in and taken away, and the table follows.
#include <QHeaderView>
#include <QMouseEvent>
#include <QScrollBar>
#include <QTableWidget>
#include <QTest>

#include "driven_window.hpp"
#include "listed_runs.hpp"
#include "widgets/forms/curve_editor.hpp"

namespace talus {
namespace {

class Curves : public DrivenWindow {
 protected:
  void SetUp() override {
    DrivenWindow::SetUp();
    window->open(slidingCube(40));
    Project changed = session->project.document().project();
    changed.loads = {{.block = "cube",
                      .at = {2, 2, 3},
                      .force = Vec3::Zero(),
                      .table = {{0, {0, 0, 0}}, {1, {0, 0, -100e3}}, {2, {50e3, 0, -100e3}}}}};
    session->project.document().change(changed, QStringLiteral("act"));
    session->display.goTo(WorkflowPage::loads);
    session->project.selection().select({Item::Kind::load, 0});
    rest(50);
  }
  const TimeTable& rows() { return session->project.document().project().loads[0].table; }
  CurveEditor& plot() { return *window->findChild<CurveEditor*>(QStringLiteral("/loads/0/table#plot")); }
  QTableWidget& table() { return *window->findChild<QTableWidget*>(QStringLiteral("/loads/0/table")); }
  int steps() { return session->project.document().undoStack().count(); }
  void drag(QPoint from, QPoint to) {
    CurveEditor* editor = &plot();
    QTest::mousePress(editor, Qt::LeftButton, {}, from);
    for (const QPoint& at : {(from + to) / 2, to}) {
      QMouseEvent move(QEvent::MouseMove, QPointF(at), editor->mapToGlobal(QPointF(at)), Qt::NoButton, Qt::LeftButton,
                       Qt::NoModifier);
      QApplication::sendEvent(editor, &move);
    }
    between = table().item(1, 3) ? table().item(1, 3)->text() : QString();
    QTest::mouseRelease(editor, Qt::LeftButton, {}, to);
    rest(30);
  }
  QString between;  ///< what the table said of the second row's z before the hand let go
};

TEST_F(Curves, NumbersOfManyDigitsAreWholeInTheirCells) {
  Project changed = session->project.document().project();
  for (const double share : {1.0, 1e3}) {  // with room for all, and where it has to be scrolled to
    changed.loads[0].table = {{0, {0, 0, 0}}, {1, {share / 3, -share / 7, share / 11}}};
    session->project.document().change(changed, QStringLiteral("thirds"));
    rest(50);
    const QAbstractItemView& cells = table();
    for (int column = 0; column < table().columnCount(); ++column)
      EXPECT_GE(table().columnWidth(column), cells.sizeHintForColumn(column)) << column;
    const auto& head = *table().horizontalHeader();
    EXPECT_GE(head.length(), table().viewport()->width()) << "no room is left";
    EXPECT_EQ(head.length() > table().viewport()->width(), table().horizontalScrollBar()->isVisible());
    EXPECT_GE(table().viewport()->height(), 2 * table().rowHeight(0)) << "its bar hides no row";
  }
}

TEST_F(Curves, APointIsDraggedInOneStepAndTheTableFollows) {
  const int before = steps();
  const QPoint point = plot().pointPlace(1, 2).toPoint();
  drag(point, point + QPoint(20, -20));
  EXPECT_EQ(steps(), before + 1) << "a gesture is one step";
  ASSERT_EQ(rows().size(), 3u);
  EXPECT_GT(rows()[1].time, 1);
  EXPECT_LT(rows()[1].time, 2);
  EXPECT_GT(rows()[1].value.z(), -100e3);
  EXPECT_EQ(rows()[1].value.x(), 0) << "the other curves keep their values";
  EXPECT_EQ(table().item(1, 3)->text(), between) << "the table said so already while it was dragged";
  keepPicture(*window, "curves.png");
  session->project.document().undoStack().undo();
  EXPECT_EQ(rows()[1].time, 1);
}

TEST_F(Curves, APointStaysBetweenItsNeighbours) {
  const QPoint point = plot().pointPlace(1, 2).toPoint();
  drag(point, point + QPoint(400, 0));
  EXPECT_LT(rows()[1].time, rows()[2].time);
  EXPECT_GT(rows()[1].time, 1.9);
}

TEST_F(Curves, ADoubleClickOnACurvePutsAPointInAndDeleteTakesItAway) {
  const QPoint middle = ((plot().pointPlace(1, 2) + plot().pointPlace(0, 2)) / 2).toPoint();
  QTest::mouseDClick(&plot(), Qt::LeftButton, {}, middle);
  rest(30);
  ASSERT_EQ(rows().size(), 4u);
  EXPECT_NEAR(rows()[1].time, 0.5, 0.03);
  EXPECT_NEAR(rows()[1].value.z(), -100e3 * rows()[1].time, 1) << "on the line between its neighbours";
  EXPECT_EQ(table().currentRow(), 1) << "it is chosen in the table too";
  plot().setFocus();
  QTest::keyClick(&plot(), Qt::Key_Delete);
  rest(30);
  EXPECT_EQ(rows().size(), 3u);
}

TEST_F(Curves, TheKeyboardChoosesAndMovesPoints) {
  table().setCurrentCell(1, 3);
  plot().setFocus();
  QTest::keyClick(&plot(), Qt::Key_Right);
  EXPECT_EQ(table().currentRow(), 2);
  QTest::keyClick(&plot(), Qt::Key_Left);
  QTest::keyClick(&plot(), Qt::Key_Up, Qt::ControlModifier);
  rest(30);
  EXPECT_GT(rows()[1].value.z(), -100e3);
  const double once = rows()[1].value.z();
  EXPECT_EQ(QApplication::focusWidget(), &plot()) << "the form was made anew, the keyboard is where it was";
  QTest::keyClick(&plot(), Qt::Key_Up, Qt::ControlModifier);
  rest(30);
  EXPECT_GT(rows()[1].value.z(), once) << "and so is the point";
}

}  // namespace
}  // namespace talus
