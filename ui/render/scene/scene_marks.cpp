// Places that are marked in the picture: where a run has trouble to converge, and those that were asked for.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "base/units.hpp"
#include "render/paint/place_marks.hpp"
#include "render/scene/scene_state.hpp"

namespace talus {

namespace {

constexpr double room_round_a_block = 1.8;  ///< height of the view over the size of the block looked at

}  // namespace

std::vector<int> Scene::State::blocks_of(const ConvergenceTrouble& trouble) const {
  std::vector<int> found;
  for (std::size_t b = 0; b < system.blocks.size(); ++b)
    if (const std::string& name = system.blocks[b].name; name == trouble.blocks[0] || name == trouble.blocks[1])
      found.push_back(static_cast<int>(b));
  return found;
}

void Scene::State::mark_troubles() {
  std::set<int> troubled;
  if (settings.troubles)
    for (const ConvergenceTrouble& trouble : troubles)
      for (const int block : blocks_of(trouble)) troubled.insert(block);
  concern.mark(std::vector<int>(troubled.begin(), troubled.end()));
}

void Scene::State::mark_hovered() { hover.mark(hovered ? std::vector<int>{*hovered} : std::vector<int>{}); }

Vec3 Scene::State::place_of(const ConvergenceTrouble& trouble) const {
  const BlockActors* const going = &movable;
  return drawn_place({&going, 1}, flags(blocks_of(trouble)), trouble.rest_position, trouble.position);
}

CameraPose Scene::State::pose_at(const ConvergenceTrouble& trouble) const {
  double size = rock_size;
  for (const int block : blocks_of(trouble)) {
    Eigen::AlignedBox3d box;
    for (const Vec3& node : system.blocks[static_cast<std::size_t>(block)].mesh.nodes) box.extend(node);
    size = std::min(size, box.diagonal().norm());
  }
  return pose_at(place_of(trouble), size);
}

CameraPose Scene::State::pose_at(const Vec3& place, double size) const {
  CameraPose wanted = pose();
  const Vec3 forward = (wanted.focal_point - wanted.position).normalized();
  const double half_height = room_round_a_block * size / 2;
  wanted.focal_point = place;
  wanted.position = wanted.focal_point - forward * half_height / std::tan(radians(wanted.view_angle) / 2);
  wanted.parallel_scale = half_height;
  return wanted;
}

void Scene::State::paint_marks(Painter& painter, std::vector<PixelRect> taken) const {
  std::vector<PlaceMark> marks;
  const auto mark = [&](const Vec3& place, const std::string& label) {
    if (const auto pixel = pixel_of(place - origin)) marks.push_back({*pixel, label});
  };
  for (const ConvergenceTrouble& trouble : troubles)
    if (settings.troubles && !blocks_of(trouble).empty()) mark(place_of(trouble), contact_text(trouble));
  for (const MarkedPlace& place : settings.places) mark(place.at, place.label);
  const auto [width, height] = size();
  talus::paint_marks(painter, marks, {settings.theme, text_height(), width, height, std::move(taken)});
}

}  // namespace talus
