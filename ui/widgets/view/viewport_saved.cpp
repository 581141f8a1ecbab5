// What the 3-D view shows of results, as a view file keeps it.
#include <algorithm>

#include "document/selection.hpp"
#include "session/display.hpp"
#include "session/playback.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

std::optional<SavedView> Viewport::savedView() const {
  const auto frame = playback().frame();
  if (!scene_ || !frame || showsSolids_) return std::nullopt;
  const auto names = [this](const std::vector<int>& blocks) {
    std::vector<std::string> list;
    for (const int block : blocks) list.push_back(system_->blocks[static_cast<std::size_t>(block)].name);
    return list;
  };
  SavedView view;
  const int* size = surface_->window().GetSize();
  view.width = size[0];
  view.height = size[1];
  view.time = frame->time;
  view.settings = scene_->settings();
  view.settings.places.clear();
  view.settings.title = displayed().title;  // not what tells it from those beside it
  if (const auto range = scene_->shown_range()) view.settings.range = range;
  if (displayed().field != view.settings.field) view.settings.range.reset();
  view.camera = scene_->pose();
  view.hidden = names(hidden_);
  view.selected = names(selectedInView());
  view.covered = coveredByTools();
  return view;
}

void Viewport::show(const SavedView& view) {
  if (!scene_ || showsSolids_) return;
  hidden_ = blocks_named(*system_, view.hidden);
  scene_->set_hidden(hidden_);
  selection().selectBlocks(blocks_named(*system_, view.selected));
  display().show(view.settings);
  if (view.time) playback().showTime(*view.time);
  moveCamera(view.camera);
}

std::vector<PixelRect> Viewport::coveredByTools() const {
  if (tools_->isHidden()) return {};
  const double ratio = devicePixelRatioF();
  const QRect tools = tools_->geometry();
  return {PixelRect{tools.x() * ratio, (height() - tools.y() - tools.height()) * ratio,
                    (tools.x() + tools.width()) * ratio, (height() - tools.y()) * ratio}};
}

void Viewport::keepLabelsBesideTools() {
  if (scene_) scene_->set_covered(coveredByTools());
}

}  // namespace talus
