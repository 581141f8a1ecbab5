#pragma once

#include <QWidget>
#include <vector>

namespace talus {

class ViewTool;

/// Over the picture of the 3-D view: what its tools draw. The mouse goes through it.
class ViewOverlay : public QWidget {
  Q_OBJECT
 public:
  explicit ViewOverlay(QWidget* parent);
  /// Asked, and drawn last, before those that were added earlier. It outlives the overlay, or takes itself out.
  void add(ViewTool& tool) { tools_.insert(tools_.begin(), &tool); }
  void remove(ViewTool& tool) { std::erase(tools_, &tool); }
  const std::vector<ViewTool*>& tools() const { return tools_; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<ViewTool*> tools_;
};

/// A dot with a number in it, as places are marked that were clicked.
void paintNumberedDot(QPainter& painter, QPointF at, int number);
/// Words on a card beside a point, which stay inside the view.
void paintValueCard(QPainter& painter, QPointF at, const QString& words, QSize view);

}  // namespace talus
