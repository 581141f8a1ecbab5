#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

namespace talus {

/// The closed profile of a section, drawn to scale with its axes. Corners are dragged; a click on an edge makes a new
/// one; Delete takes the chosen one away, arrows move it. Shift snaps to a grid. The wheel zooms to the pointer, a drag
/// beside the profile moves it, a double click shows all of it. What is drawn is the caller's: each change is handed
/// out and comes back through `setCorners`.
class SectionPlot : public QWidget {
  Q_OBJECT
 public:
  using Corners = std::vector<std::array<double, 2>>;
  SectionPlot();

  /// m: distance along the section and height.
  void setCorners(const Corners& corners);
  const Corners& corners() const { return corners_; }
  /// The outline as it is drawn is impossible: it is shown in red until it is not.
  void setRefused(bool refused);
  int chosen() const { return chosen_; }
  void fit();
  /// Where a corner is drawn, logical pixels.
  QPointF pixelOf(const std::array<double, 2>& corner) const;

 signals:
  /// `ends`: the button has been let go, or one key did it all.
  void edited(const talus::SectionPlot::Corners& corners, bool ends);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRectF area() const;
  std::array<double, 2> metresOf(QPointF pixel) const;
  std::array<double, 2> snapped(std::array<double, 2> corner) const;
  double grid() const;
  int cornerAt(QPointF pixel) const;
  /// The corner before a new one, and where on the edge that is; nothing away from all edges.
  std::optional<std::pair<int, QPointF>> edgeAt(QPointF pixel) const;
  void drawAxes(QPainter& painter) const;
  void drawProfile(QPainter& painter) const;
  void drawHandles(QPainter& painter) const;
  void takeAway();
  void nudge(double distance, double height);

  Corners corners_;
  int chosen_ = -1;
  QPointF pointer_;
  bool dragging_ = false, panning_ = false, moved_ = false, refused_ = false;
  bool fitted_ = false;                 ///< the view was not moved by hand since
  std::array<double, 2> middle_{0, 0};  ///< m, in the middle of the picture
  double pixelsPerMetre_ = 10;
};

}  // namespace talus
