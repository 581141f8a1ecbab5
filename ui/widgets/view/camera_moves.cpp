#include "widgets/view/camera_moves.hpp"

#include <QMouseEvent>
#include <QWheelEvent>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/units.hpp"

namespace talus {

namespace {

struct ScreenAxes {
  Vec3 right, up;
  double metresPerPixel;
};

double heightInMetres(const CameraPose& pose) {
  if (pose.parallel) return 2 * pose.parallel_scale;
  return 2 * (pose.position - pose.focal_point).norm() * std::tan(radians(pose.view_angle) / 2);
}

ScreenAxes screenAxes(const CameraPose& pose, QSizeF view) {
  const Vec3 forward = (pose.focal_point - pose.position).normalized();
  const Vec3 right = forward.cross(pose.view_up).normalized();
  return {right, right.cross(forward), heightInMetres(pose) / std::max(1.0, view.height())};
}

void shift(CameraPose& pose, const Vec3& by) {
  pose.position += by;
  pose.focal_point += by;
}

}  // namespace

CameraPose turned(CameraPose pose, double azimuth, double elevation) {
  constexpr double steepest = 89.5;  // degrees: at the pole itself the up vector would be undefined
  const Vec3 back = pose.position - pose.focal_point;
  const double distance = back.norm();
  double around = std::atan2(back.y(), back.x());
  // Looking straight down, only the up vector knows which way is north.
  if (std::hypot(back.x(), back.y()) < 1e-3 * distance) around = std::atan2(-pose.view_up.y(), -pose.view_up.x());
  const double above = degrees(std::asin(std::clamp(back.z() / distance, -1.0, 1.0)));
  const double newAbove = radians(std::clamp(above + elevation, -steepest, steepest));
  around += radians(azimuth);
  pose.position = pose.focal_point + distance * Vec3(std::cos(newAbove) * std::cos(around),
                                                     std::cos(newAbove) * std::sin(around), std::sin(newAbove));
  pose.view_up = Vec3::UnitZ();
  return pose;
}

CameraPose panned(CameraPose pose, QPointF by, QSizeF view) {
  const ScreenAxes axes = screenAxes(pose, view);
  shift(pose, (-by.x() * axes.right + by.y() * axes.up) * axes.metresPerPixel);
  return pose;
}

CameraPose zoomed(CameraPose pose, double factor, QPointF pointer, QSizeF view) {
  const ScreenAxes axes = screenAxes(pose, view);
  const QPointF fromCentre = pointer - QPointF(view.width() / 2, view.height() / 2);
  const Vec3 under = (fromCentre.x() * axes.right - fromCentre.y() * axes.up) * axes.metresPerPixel;
  shift(pose, under * (1 - factor));
  pose.parallel_scale *= factor;
  pose.position = pose.focal_point + (pose.position - pose.focal_point) * factor;
  return pose;
}

CameraPose between(const CameraPose& from, const CameraPose& to, double share) {
  CameraPose pose = to;
  pose.position = from.position + share * (to.position - from.position);
  pose.focal_point = from.focal_point + share * (to.focal_point - from.focal_point);
  pose.parallel_scale = from.parallel_scale + share * (to.parallel_scale - from.parallel_scale);
  return pose;
}

CameraPose withOtherProjection(CameraPose pose) {
  const double height = heightInMetres(pose);
  pose.parallel = !pose.parallel;
  if (pose.parallel) {
    pose.parallel_scale = height / 2;
  } else {
    const Vec3 back = (pose.position - pose.focal_point).normalized();
    pose.position = pose.focal_point + back * (height / 2 / std::tan(radians(pose.view_angle) / 2));
  }
  return pose;
}

bool CameraMouse::takes(const QEvent& event, const CameraPose& pose, QSizeF view,
                        const std::function<void(const CameraPose&)>& move) {
  constexpr double nearer_of_notch = 0.85;
  if (event.type() == QEvent::MouseButtonPress) {
    last_ = static_cast<const QMouseEvent&>(event).position();
    return true;
  }
  if (event.type() == QEvent::MouseMove) {
    const auto& mouse = static_cast<const QMouseEvent&>(event);
    const QPointF by = mouse.position() - last_;
    last_ = mouse.position();
    if (mouse.buttons().testFlag(Qt::LeftButton))
      move(turned(pose, -by.x() * degrees_of_pixel_, by.y() * degrees_of_pixel_));
    else if (mouse.buttons().testFlag(Qt::MiddleButton))
      move(panned(pose, by, view));
    return true;
  }
  if (event.type() != QEvent::Wheel) return false;
  const auto& wheel = static_cast<const QWheelEvent&>(event);
  const double notches = wheel.angleDelta().y() / 120.0;
  move(zoomed(pose, std::pow(nearer_of_notch, notches), wheel.position(), view));
  return true;
}

}  // namespace talus
