#pragma once

#include "widgets/kit/plot.hpp"

namespace talus {

/// Curves of one time table, edited by hand: a point is dragged between its neighbours, put in by a double click on a
/// curve, taken away by Delete. Arrow keys go from point to point and from curve to curve, with Ctrl they move the
/// point. Every curve has a point in every row; its colour is its number among all components.
class CurveEditor : public Plot {
  Q_OBJECT
 public:
  explicit CurveEditor(const QString& title);
  /// The point of a row; a curve that is not drawn stands for the first one.
  void choose(int row, int curve);
  /// Where the point of a row is drawn; the curve by its number among all components.
  QPointF pointPlace(int row, int curve) const;

 signals:
  void chosen(int row, int curve);
  void dragged(int row, int curve, double time, double value);  ///< s, in the plot's unit; while the hand moves
  void moved(int row, int curve, double time, double value);    ///< it has let go
  void inserted(double time);
  void removed(int row);
  void pasteWanted();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Point {
    int curve = -1, row = -1;  ///< index into curves(), and of its points
    bool isThere() const { return curve >= 0 && row >= 0; }
  };
  Point pointAt(QPointF place) const;
  QPointF placeOf(const Point& point) const;
  /// The chosen point goes as near to there as its neighbours let it.
  void moveTo(double time, double value);
  void moveBy(int columns, int rows);
  void take(const Point& point);
  void drawHint(QPainter& painter) const;

  Point chosen_;
  bool dragging_ = false, moved_ = false;
};

}  // namespace talus
