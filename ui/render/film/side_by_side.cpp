#include "render/film/side_by_side.hpp"

#include <algorithm>

#include "render/paint/panel_grid.hpp"

namespace talus {

namespace {

constexpr int between_panels = 3;  // pixels between two of them

void paste(Image& whole, const Image& part, int left, int top) {
  for (int y = 0; y < part.height; ++y)
    std::copy_n(part.rgb.begin() + static_cast<std::ptrdiff_t>(y) * part.width * 3, part.width * 3,
                whole.rgb.begin() + (static_cast<std::ptrdiff_t>(y + top) * whole.width + left) * 3);
}

/// Where a panel begins along a side, pixels; that behind the last one: where the side ends, and a line more.
int begin_of(int panel, int panels, int side) { return panel * (side + between_panels) / panels; }

}  // namespace

SideBySideView::SideBySideView(std::vector<Scene*> scenes, int width, int height, Sampling sampling)
    : scenes_(std::move(scenes)), width_(width), height_(height) {
  const int count = static_cast<int>(scenes_.size());
  const auto [columns, rows] = panel_grid(count, width, height);
  for (int i = 0; i < count; ++i) {
    const int column = i % columns, row = i / columns, next = i + 1 < count ? column + 1 : columns;
    const int left = begin_of(column, columns, width), top = begin_of(row, rows, height);
    const int own_width = begin_of(next, columns, width) - left - between_panels;
    const int own_height = begin_of(row + 1, rows, height) - top - between_panels;
    panels_.push_back(
        {std::make_unique<OffscreenView>(*scenes_[static_cast<std::size_t>(i)], own_width, own_height, sampling), left,
         top});
  }
}

SideBySideView::~SideBySideView() = default;

void SideBySideView::hold_camera() {
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
  for (const Panel& panel : panels_) paste(whole, panel.view->draw(), panel.left, panel.top);
  return whole;
}

}  // namespace talus
