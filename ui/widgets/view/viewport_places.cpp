// Points of the 3-D view and places of the rock: what lies where.
#include <Eigen/Geometry>

#include "session/session.hpp"
#include "widgets/view/render_surface.hpp"
#include "widgets/view/view_overlay.hpp"
#include "widgets/view/viewport.hpp"

namespace talus {

std::optional<Pick> Viewport::pickAt(QPointF point) const {
  if (!scene_) return std::nullopt;
  const double ratio = devicePixelRatioF();
  return scene_->pick(point.x() * ratio, point.y() * ratio);
}

PickedPlace Viewport::placeOf(const Pick& pick) const {
  const Block& block = system_->blocks.at(static_cast<size_t>(pick.block));
  const SurfaceTriangle& facet = block.surface.at(static_cast<size_t>(pick.facet));
  const auto corner = [&](int i) { return block.mesh.nodes[static_cast<size_t>(facet.nodes[static_cast<size_t>(i)])]; };
  PickedPlace place;
  place.block = pick.block;
  place.solid = block.solid;
  place.joint = facet.joint;
  place.point = pick.rest;
  place.normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
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
  return pointOf(place.block >= 0 ? scene_->drawn_place(place.block, place.point) : place.point);
}

std::optional<SightLine> Viewport::sightAt(QPointF point) const {
  if (!scene_) return std::nullopt;
  const double ratio = devicePixelRatioF();
  return scene_->sight_at(point.x() * ratio, point.y() * ratio);
}

void Viewport::markFace(const std::optional<Pick>& pick) {
  if (!scene_) return;
  scene_->set_marked_face(pick);
  render();
}

void Viewport::usePointer(Qt::CursorShape shape) { surface_->widget()->setCursor(shape); }

}  // namespace talus
