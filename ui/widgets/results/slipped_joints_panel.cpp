#include "widgets/results/slipped_joints_panel.hpp"

#include "render/stereonet/slipped_joints.hpp"
#include "render/stereonet/stereonet_picture.hpp"
#include "session/measured_slide.hpp"

namespace talus {

SlippedJointsPanel::SlippedJointsPanel(SlippedJoints& slips)
    : SlippedJointsPanel(slips, new PaintingView(tr("Net of the joints that slipped"))) {}

SlippedJointsPanel::SlippedJointsPanel(SlippedJoints& slips, PaintingView* net)
    : ExplainedPanel(net), slips_(slips), net_(net) {
  connect(&slips_, &SlippedJoints::changed, this, &SlippedJointsPanel::refresh);
  refresh();
}

void SlippedJointsPanel::showEvent(QShowEvent*) { slips_.setWatched(true); }

void SlippedJointsPanel::hideEvent(QHideEvent*) { slips_.setWatched(false); }

void SlippedJointsPanel::refresh() {
  const auto& slips = slips_.slips();
  const bool any = slips && !slips->faces.empty();
  explain(any                           ? QString()
          : !slips_.problem().isEmpty() ? slips_.problem()
          : slips_.isBusy()             ? tr("The frames are being looked at …")
          : !slips ? tr("On which joints blocks slid is told of results on disk, when a run is over.")
                   : tr("No block slid on another one that it lay against."));
  if (!any) return net_->setPainting({});
  Stereonet net;
  net.joints = joints_that_slipped(slips->faces, slips->joint_names);
  net.theme = slips_.theme();
  net_->setPainting(stereonet_painting(net, {}));
}

}  // namespace talus
