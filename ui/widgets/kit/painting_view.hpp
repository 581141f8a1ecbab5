#pragma once

#include <QWidget>

#include "render/paint/painter.hpp"

namespace talus {

/// Shows what pictures and reports are painted with, as large as it is itself.
class PaintingView : public QWidget {
  Q_OBJECT
 public:
  explicit PaintingView(const QString& name);
  /// Empty: nothing is shown.
  void setPainting(Painting painting);
  bool hasPainting() const { return static_cast<bool>(painting_); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Painting painting_;
};

}  // namespace talus
