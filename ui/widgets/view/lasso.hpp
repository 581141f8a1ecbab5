#pragma once

#include <QPolygonF>
#include <QWidget>

namespace talus {

/// A line that the hand draws around things, closed by itself, over the view.
class Lasso : public QWidget {
  Q_OBJECT
 public:
  explicit Lasso(QWidget* view);
  void begin(QPointF at);
  void extend(QPointF to);
  /// What was drawn around, and the line is gone.
  QPolygonF take();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPolygonF outline_;
};

}  // namespace talus
