// Points of the 3-D view and places of the rock: what lies where.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "render/scene/block_surface.hpp"
#include "session/picking.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/view/view_overlay.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

std::optional<Pick> Viewport::pickAt(QPointF point) const {
  if (!scene_ || isStale()) return std::nullopt;
  const double ratio = devicePixelRatioF();
  return scene_->pick(point.x() * ratio, point.y() * ratio);
}

PickedPlace Viewport::placeOf(const Pick& pick) const {
  const Block& block = system_->blocks.at(static_cast<size_t>(pick.block));
  const SurfaceTriangle& facet = block.surface.at(static_cast<size_t>(pick.facet));
  const auto corner = [&](int i) -> const Vec3& {
    return block.mesh.nodes[static_cast<size_t>(facet.nodes[static_cast<size_t>(i)])];
  };
  PickedPlace place;
  place.block = showsSolids_ ? -1 : pick.block;
  place.solid = block.solid;
  place.joint = facet.joint;
  place.point = pick.rest;
  const Vec3 area = (corner(1) - corner(0)).cross(corner(2) - corner(0));
  place.normal = area.normalized();
  const std::shared_ptr<const Frame> frame = shownFrame();
  if (!frame) return place;
  size_t first = 0;
  for (int b = 0; b < pick.block; ++b) first += system_->blocks[static_cast<size_t>(b)].mesh.nodes.size();
  const auto moved = [&](int i) -> const Vec3& {
    return frame->displacement[first + static_cast<size_t>(facet.nodes[static_cast<size_t>(i)])];
  };
  Vec3 point = place.point;
  for (int i = 0; i < 3; ++i) {  // by the corners' shares in it
    const Vec3 &one = corner((i + 1) % 3), &other = corner((i + 2) % 3);
    point += (other - one).cross(place.point - one).dot(area) / area.squaredNorm() * moved(i);
  }
  const auto now = [&](int i) -> Vec3 { return corner(i) + moved(i); };
  place.now = {point, (now(1) - now(0)).cross(now(2) - now(0)).normalized()};
  return place;
}

std::optional<QPointF> Viewport::pointOf(const Vec3& point) const {
  if (!scene_) return std::nullopt;
  const auto pixel = scene_->pixel_of(point);
  if (!pixel) return std::nullopt;
  return QPointF((*pixel)[0], (*pixel)[1]) / devicePixelRatioF();
}

std::optional<QPointF> Viewport::pointOf(const PickedPlace& place) const {
  if (!scene_) return std::nullopt;
  // The blocks on which it was asked for may have made way for the solids, or for others of another number.
  const bool isOnABlock = !showsSolids_ && place.block >= 0 && place.block < static_cast<int>(system_->blocks.size());
  return pointOf(isOnABlock ? scene_->drawn_place(place.block, place.point) : place.point);
}

std::optional<SightLine> Viewport::sightAt(QPointF point) const {
  if (!scene_) return std::nullopt;
  const double ratio = devicePixelRatioF();
  return scene_->sight_at(point.x() * ratio, point.y() * ratio);
}

double Viewport::metresPerPixel(const Vec3& place) const {
  if (!scene_) return 1;
  const CameraPose pose = scene_->pose();
  const Vec3 forward = (pose.focal_point - pose.position).normalized();
  const double half =
      pose.parallel ? pose.parallel_scale : forward.dot(place - pose.position) * std::tan(radians(pose.view_angle) / 2);
  return 2 * half / std::max(1, height());
}

std::optional<Eigen::AlignedBox3d> Viewport::extent() const {
  if (!system_) return std::nullopt;
  return bounds(*system_);
}

std::optional<int> Viewport::jointAt(QPointF point) const {
  if (!scene_ || !showsJoints()) return std::nullopt;
  const double ratio = devicePixelRatioF();
  return scene_->joint_at(point.x() * ratio, point.y() * ratio);
}

void Viewport::markFace(const std::optional<Pick>& pick) {
  if (!scene_) return;
  scene_->set_marked_face(pick);
  render();
}

void Viewport::usePointer(Qt::CursorShape shape) { surface_->widget()->setCursor(shape); }

}  // namespace talus
