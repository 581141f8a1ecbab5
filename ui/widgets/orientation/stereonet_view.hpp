#pragma once

#include <QPixmap>
#include <QWidget>
#include <optional>

#include "render/stereonet/stereonet.hpp"

namespace talus {

/// A stereonet that can be worked with: a click on a pole chooses its joint, the arrow keys go from pole to pole, a
/// drag draws a window of dips and directions, with Shift a cone. It may be dragged over the rim: what lies beyond are
/// planes that dip the other way.
class StereonetView : public QWidget {
  Q_OBJECT
 public:
  StereonetView();

  /// What lies on the net; its selection and its window are drawn by the view.
  void show(Stereonet net);
  const DrawnNet& drawn() const { return drawn_; }
  void setSelected(std::vector<std::size_t> joints);
  void setWindow(const std::optional<SetWindow>& window);

  /// Where the pole of a joint, or any line, is. Pixels.
  QPointF pointOf(std::size_t joint) const;
  QPointF pointOf(const Vec3& line) const;

 signals:
  /// Nothing: a click where no pole is.
  void chosen(std::optional<std::size_t> joint);
  void windowDrawn(const talus::SetWindow& window);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  QSize sizeHint() const override { return {520, 520}; }

 private:
  double radius() const;
  QPointF centre() const { return QRectF(rect()).center(); }
  Vec3 lineAt(const QPointF& place) const;
  std::optional<std::size_t> poleAt(const QPointF& place) const;
  SetWindow windowBetween(const QPointF& from, const QPointF& to, bool cone) const;
  void drawPicture();
  void paintKey(QPainter& painter) const;
  void tell(const QPoint& where, const QPointF& place);

  Stereonet net_;
  DrawnNet drawn_;
  QPixmap picture_;  ///< all but selection and window; empty: has to be drawn
  std::vector<std::size_t> selected_;
  std::optional<SetWindow> window_;
  std::optional<QPointF> pressed_;
  bool dragging_ = false;
};

}  // namespace talus
