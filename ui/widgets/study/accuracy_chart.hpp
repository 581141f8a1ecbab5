#pragma once

#include <QRectF>
#include <QWidget>
#include <optional>
#include <vector>

#include "render/charts/log_axis.hpp"
#include "study/accuracy/accuracy.hpp"

namespace talus {

/// Error against seconds of a study's runs, both logarithmic, with the front of the best drawn through. A run is chosen
/// by a click on its point, or with the arrow keys.
class AccuracyChart : public QWidget {
  Q_OBJECT
 public:
  AccuracyChart();
  void show(const AccuracyStudy& study);
  void setChosen(std::optional<int> run);
  /// Where the point of a run is; nothing for a run without an error.
  std::optional<QPointF> pointOf(int run) const;

 signals:
  void chosen(int run);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Point {
    int run = 0;
    QString words;
    double seconds = 0, error = 0, uncertainty = 0;
    bool best = false;
  };
  QRectF area() const;
  QPointF at(double seconds, double error) const;
  const Point* nearest(const QPointF& place) const;
  void drawAxes(QPainter& painter) const;
  void drawTarget(QPainter& painter) const;
  void drawPoints(QPainter& painter) const;
  void drawDot(QPainter& painter, const QPointF& place, bool best) const;

  std::vector<Point> points_;  ///< the cheapest first
  std::optional<double> target_;
  std::optional<int> chosen_;
  LogAxis seconds_, errors_;
};

}  // namespace talus
