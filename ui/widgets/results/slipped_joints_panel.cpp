#include "widgets/results/slipped_joints_panel.hpp"

#include <QVBoxLayout>

#include "render/stereonet/slipped_joints.hpp"
#include "render/stereonet/stereonet_picture.hpp"
#include "session/measured_slide.hpp"
#include "widgets/kit/parts.hpp"

namespace talus {

SlippedJointsPanel::SlippedJointsPanel(SlippedJoints& slips)
    : slips_(slips),
      sentence_(makeWrappedLabel({}, "muted")),
      net_(new PaintingView(tr("Net of the joints that slipped"))) {
  setProperty("plane", "surface");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  setMargins(column, 0, 0);
  sentence_->setAlignment(Qt::AlignCenter);
  column->addWidget(sentence_, 1);
  column->addWidget(net_, 1);
  connect(&slips_, &SlippedJoints::changed, this, &SlippedJointsPanel::refresh);
  refresh();
}

void SlippedJointsPanel::showEvent(QShowEvent*) { slips_.setWatched(true); }

void SlippedJointsPanel::hideEvent(QHideEvent*) { slips_.setWatched(false); }

void SlippedJointsPanel::refresh() {
  const auto& slips = slips_.slips();
  const bool any = slips && !slips->faces.empty();
  sentence_->setText(!slips_.problem().isEmpty() ? slips_.problem()
                     : slips_.isBusy()           ? tr("The frames are being looked at …")
                     : !slips ? tr("On which joints blocks slid is told of results on disk, when a run is over.")
                              : tr("No block slid on another one that it lay against."));
  sentence_->setVisible(!any);
  net_->setVisible(any);
  if (!any) return net_->setPainting({});
  Stereonet net;
  net.joints = joints_that_slipped(slips->faces, slips->joint_names);
  net.theme = slips_.theme();
  net_->setPainting(stereonet_painting(net, {}));
}

}  // namespace talus
