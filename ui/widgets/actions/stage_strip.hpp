#pragma once

#include <QWidget>
#include <vector>

#include "document/selection.hpp"

namespace talus {

class CurrentProject;
class Display;
class Messages;
struct Stage;

/// The stages one behind the other in time: each with its name, type, length, and chips that say what it changes. A
/// click selects, the right edge is dragged to another length, a stage to another place in the order; each is one step
/// that can be undone. Short stages are drawn wider than they last, so that they can be read and taken hold of.
class StageStrip : public QWidget {
  Q_OBJECT
 public:
  StageStrip(CurrentProject& project, Messages& messages, Display& display);
  QSize sizeHint() const override;
  /// Where a stage is drawn.
  QRectF boxOf(int stage) const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  enum class Drag { none, pressed, length, order };
  const std::vector<Stage>& stages() const;
  int stageAt(QPointF place) const;
  /// The stage whose right edge is there; −1 for none.
  int edgeAt(QPointF place) const;
  /// Number of the place in the order that a stage dropped there takes.
  int orderAt(double x) const;
  /// s: what the stage lasts when its edge is dragged there, in whole time steps.
  double lengthAt(double x) const;
  void setLength(int stage, double seconds);
  void move(int stage, int by);
  void select(int stage);
  QString words(int stage) const;
  void paintStage(QPainter& painter, int stage) const;
  void paintChips(QPainter& painter, const QRectF& row, const QStringList& chips) const;
  void describe();

  CurrentProject& project_;
  Messages& messages_;
  Drag drag_ = Drag::none;
  int held_ = -1;  ///< the stage that is dragged
  QPointF pressed_, pointer_;
};

}  // namespace talus
