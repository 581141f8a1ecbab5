#pragma once

#include <QWidget>

#include "mesh/mesh_survey.hpp"

namespace talus {

/// How many tetrahedra are how well shaped: bars over the measure, the poor ones amber.
class QualityChart : public QWidget {
  Q_OBJECT
 public:
  explicit QualityChart(QWidget* parent = nullptr);
  /// Bars below `poor` are amber; `decimals` and `unit` of the measure's figures.
  void show(const Histogram& histogram, double poor, int decimals, const QString& unit);
  void clear();
  /// Sum of all bars.
  long count() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  QRectF plot() const;
  QRectF barOf(std::size_t bin) const;

  Histogram histogram_;
  double poor_ = 0;
  int decimals_ = 1;
  QString unit_;
  int pointed_ = -1;  ///< the bin under the pointer
};

}  // namespace talus
