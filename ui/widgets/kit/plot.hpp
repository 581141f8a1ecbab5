#pragma once

#include <QRectF>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

namespace talus {

/// A curve: `x` ascends. Values that are not finite break it.
struct Curve {
  QString name;
  int colour = 0;  ///< number in theme::seriesColour
  std::vector<double> x, y;
};

/// Curves over time, drawn quickly: of ten thousand points each pixel column draws only its extremes.
class Plot : public QWidget {
  Q_OBJECT
 public:
  explicit Plot(const QString& title);
  void setCurves(std::vector<Curve> curves, const QString& unit);
  /// s; a line across the plot with the curves' values there. Empty: none.
  void setCursor(std::optional<double> x);
  const std::vector<Curve>& curves() const { return curves_; }
  QString unit() const { return unit_; }

 signals:
  /// The user pointed at this moment, s.
  void timeChosen(double x);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

  double xAt(double time) const;
  double yAt(double value) const;
  double timeAt(double x) const;
  double valueAtHeight(double y) const;
  /// Other values on the axes that are there.
  void redraw(std::vector<Curve> curves);
  const QRectF& area() const { return area_; }

 private:
  struct Range {
    double low = 0, high = 1;
  };
  void fitArea();
  void fitRanges();
  void chooseTime(double x);
  void drawHeading(QPainter& painter) const;
  void drawAxes(QPainter& painter) const;
  void drawCurve(QPainter& painter, const Curve& curve) const;
  void drawNames(QPainter& painter) const;
  void drawCursor(QPainter& painter) const;
  void drawValuesAtCursor(QPainter& painter) const;

  QString title_, unit_;
  std::vector<Curve> curves_;
  Range x_, y_;
  QRectF area_;  ///< between the axes, logical pixels
  std::vector<double> yTicks_, xTicks_;
  std::optional<double> cursor_;
};

/// The value of a curve at x, between its points; empty outside of them.
std::optional<double> valueAt(const Curve& curve, double x);

}  // namespace talus
