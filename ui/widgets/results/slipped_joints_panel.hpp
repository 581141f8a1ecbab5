#pragma once

#include <QLabel>
#include <QWidget>

#include "widgets/kit/painting_view.hpp"

namespace talus {

class SlippedJoints;

/// The net of the joints on which blocks slid in the results that are open.
class SlippedJointsPanel : public QWidget {
  Q_OBJECT
 public:
  explicit SlippedJointsPanel(SlippedJoints& slips);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void refresh();

  SlippedJoints& slips_;
  QLabel* sentence_;
  PaintingView* net_;
};

}  // namespace talus
