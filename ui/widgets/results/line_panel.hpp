#pragma once

#include <QWidget>

#include "widgets/kit/painting_view.hpp"

class QLabel;
class QPushButton;

namespace talus {

class FieldLine;
class Messages;

/// The field that is shown along a line between two points that are clicked in the view, in the frame in view, as a
/// chart and as a table to save.
class LinePanel : public QWidget {
  Q_OBJECT
 public:
  LinePanel(FieldLine& line, Messages& messages);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();

  FieldLine& line_;
  Messages& messages_;
  QLabel* words_;
  QPushButton *save_, *remove_;
  PaintingView* chart_;
};

}  // namespace talus
