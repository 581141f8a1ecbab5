#include "render/film/side_by_side.hpp"

#include <algorithm>

#include "render/paint/panel_grid.hpp"

namespace talus {

namespace {

void paste(Image& whole, const Image& part, int left, int top) {
  for (int y = 0; y < part.height; ++y)
    std::copy_n(part.rgb.begin() + static_cast<std::ptrdiff_t>(y) * part.width * 3, part.width * 3,
                whole.rgb.begin() + (static_cast<std::ptrdiff_t>(y + top) * whole.width + left) * 3);
}

}  // namespace

SideBySideView::SideBySideView(std::vector<Scene*> scenes, int width, int height, Sampling sampling)
    : scenes_(std::move(scenes)), width_(width), height_(height) {
  const std::vector<PanelPlace> places = panel_places(static_cast<int>(scenes_.size()), width, height);
  for (std::size_t i = 0; i < scenes_.size(); ++i)
    panels_.push_back({std::make_unique<OffscreenView>(*scenes_[i], places[i].width, places[i].height, sampling),
                       places[i].left, places[i].top});
}

SideBySideView::~SideBySideView() = default;

/// All stand in their panel as the first one does, beside whose legend they have none.
void SideBySideView::stand_alike() {
  for (std::size_t i = 1; i < scenes_.size(); ++i) scenes_[i]->set_rock_area(scenes_.front()->rock_area());
}

void SideBySideView::hold_camera() {
  stand_alike();
  const bool fits = scenes_.front()->fits_itself();
  panels_.front().view->hold_camera();
  CameraPose farthest = scenes_.front()->pose();
  double most = (farthest.position - farthest.focal_point).norm();
  for (std::size_t i = 1; i < scenes_.size(); ++i) {
    scenes_[i]->set_pose(scenes_.front()->pose());
    if (!fits) continue;
    scenes_[i]->fit();
    panels_[i].view->hold_camera();
    const CameraPose pose = scenes_[i]->pose();
    const double distance = (pose.position - pose.focal_point).norm();
    if (distance <= most) continue;
    most = distance;
    farthest = pose;
  }
  set_pose(farthest);
}

CameraPose SideBySideView::pose() const { return scenes_.front()->pose(); }

void SideBySideView::set_pose(const CameraPose& pose) {
  for (Scene* scene : scenes_) scene->set_pose(pose);
}

Image SideBySideView::draw() {
  if (panels_.size() == 1) return panels_.front().view->draw();
  Image whole(width_, height_);
  const Rgb between = colours(scenes_.front()->settings().theme).frame;
  for (std::size_t i = 0; i < whole.rgb.size(); i += 3) {
    whole.rgb[i] = between.red;
    whole.rgb[i + 1] = between.green;
    whole.rgb[i + 2] = between.blue;
  }
  for (const Panel& panel : panels_) {
    paste(whole, panel.view->draw(), panel.left, panel.top);
    if (&panel == &panels_.front()) stand_alike();
  }
  return whole;
}

}  // namespace talus
