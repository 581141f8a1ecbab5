#include "render/film/side_by_side.hpp"

#include <algorithm>

namespace talus {

namespace {

constexpr int between_panels = 3;  // pixels between two of them

void paste(Image& whole, const Image& part, int left) {
  for (int y = 0; y < part.height; ++y)
    std::copy_n(part.rgb.begin() + static_cast<std::ptrdiff_t>(y) * part.width * 3, part.width * 3,
                whole.rgb.begin() + (static_cast<std::ptrdiff_t>(y) * whole.width + left) * 3);
}

}  // namespace

SideBySideView::SideBySideView(std::vector<Scene*> scenes, int width, int height, Sampling sampling)
    : scenes_(std::move(scenes)), width_(width), height_(height) {
  const int count = static_cast<int>(scenes_.size()), each = (width - between_panels * (count - 1)) / count;
  for (int i = 0; i < count; ++i) {
    const int own = i + 1 < count ? each : width - i * (each + between_panels);  // what division leaves
    views_.push_back(std::make_unique<OffscreenView>(*scenes_[static_cast<std::size_t>(i)], own, height, sampling));
  }
}

SideBySideView::~SideBySideView() = default;

void SideBySideView::hold_camera() {
  const bool fits = scenes_.front()->fits_itself();
  views_.front()->hold_camera();
  CameraPose farthest = scenes_.front()->pose();
  double most = (farthest.position - farthest.focal_point).norm();
  for (std::size_t i = 1; i < scenes_.size(); ++i) {
    scenes_[i]->set_pose(scenes_.front()->pose());
    if (!fits) continue;
    scenes_[i]->fit();
    views_[i]->hold_camera();
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
  if (views_.size() == 1) return views_.front()->draw();
  Image whole(width_, height_);
  const Rgb between = colours(scenes_.front()->settings().theme).frame;
  for (std::size_t i = 0; i < whole.rgb.size(); i += 3) {
    whole.rgb[i] = between.red;
    whole.rgb[i + 1] = between.green;
    whole.rgb[i + 2] = between.blue;
  }
  int left = 0;
  for (const auto& view : views_) {
    const Image part = view->draw();
    paste(whole, part, left);
    left += part.width + between_panels;
  }
  return whole;
}

}  // namespace talus
