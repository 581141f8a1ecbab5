#pragma once

#include "widgets/kit/painting_view.hpp"
#include "widgets/results/explained_panel.hpp"

namespace talus {

class SlippedJoints;

/// The net of the joints on which blocks slid in the results that are open.
class SlippedJointsPanel : public ExplainedPanel {
  Q_OBJECT
 public:
  explicit SlippedJointsPanel(SlippedJoints& slips);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  SlippedJointsPanel(SlippedJoints& slips, PaintingView* net);
  void refresh();

  SlippedJoints& slips_;
  PaintingView* net_;
};

}  // namespace talus
