#include "render/scene/camera_fit.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "base/units.hpp"

namespace talus {

ViewExtent::ViewExtent() {
  constexpr int count = 400;
  constexpr double golden_angle = std::numbers::pi * (3 - 2.23606797749979);
  for (int i = 0; i < count; ++i) {  // Fibonacci's points on the sphere
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z);
    directions_.push_back({r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z});
  }
  outermost_.resize(count, Vec3::Zero());
  reach_.resize(count, -std::numeric_limits<double>::infinity());
}

void ViewExtent::include(std::span<const Vec3> points) {
  if (points.empty()) return;
  any_ = true;
  Eigen::AlignedBox3d box;
  for (const Vec3& point : points) box.extend(point);
  const Vec3 middle = box.center(), half = box.sizes() / 2;
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const Vec3& direction = directions_[i];
    if (direction.dot(middle) + direction.cwiseAbs().dot(half) < reach_[i]) continue;
    for (const Vec3& point : points) {
      const double reach = direction.dot(point);
      if (reach <= reach_[i]) continue;
      reach_[i] = reach;
      outermost_[i] = point;
    }
  }
}

std::vector<Vec3> ViewExtent::points() const { return any_ ? outermost_ : std::vector<Vec3>{}; }

Vec3 direction_to_viewer(double azimuth, double elevation) {
  const double a = radians(azimuth), e = radians(elevation);
  return {std::cos(e) * std::sin(a), std::cos(e) * std::cos(a), std::sin(e)};
}

std::array<double, 2> view_angles(View view) {
  switch (view) {
    case View::front:
      return {180, 0};
    case View::back:
      return {0, 0};
    case View::left:
      return {270, 0};
    case View::right:
      return {90, 0};
    case View::top:
      return {180, 90};
    case View::iso:
      break;
  }
  return {225, 30};
}

View view_named(std::string_view name) {
  using enum View;
  static constexpr std::pair<std::string_view, View> views[] = {{"iso", iso},   {"front", front}, {"back", back},
                                                                {"left", left}, {"right", right}, {"top", top}};
  for (const auto& [known, view] : views)
    if (known == name) return view;
  throw InputError("view " + std::string(name), "unknown view", "use iso, front, back, left, right or top");
}

CameraPose fitted(const CameraPose& look, std::span<const Vec3> points, double free_width, double free_height,
                  double picture_height) {
  if (points.empty()) return look;
  const Vec3 forward = (look.focal_point - look.position).normalized();
  const Vec3 right = forward.cross(look.view_up).normalized(), up = right.cross(forward);
  // The picture plane at distance 1 shows x within ±slope_x and y within ±slope_y of the free area.
  const double half_angle = std::tan(radians(look.view_angle) / 2);
  const double slope_x = look.parallel ? 0 : half_angle * free_width / picture_height;
  const double slope_y = look.parallel ? 0 : half_angle * free_height / picture_height;
  // A point stays inside if |x − camera x| ≤ slope (depth + distance): the four planes each hold one extreme point.
  constexpr double none = std::numeric_limits<double>::infinity();
  double left = none, bottom = none, right_side = -none, top = -none, nearest = none, farthest = -none;
  for (const Vec3& point : points) {
    const double x = point.dot(right), y = point.dot(up), z = point.dot(forward);
    left = std::min(left, x + slope_x * z);
    right_side = std::max(right_side, x - slope_x * z);
    bottom = std::min(bottom, y + slope_y * z);
    top = std::max(top, y - slope_y * z);
    nearest = std::min(nearest, z);
    farthest = std::max(farthest, z);
  }
  CameraPose pose = look;
  const double middle = (nearest + farthest) / 2;
  double distance = farthest - nearest + 1;
  if (look.parallel) {
    pose.parallel_scale = std::max((top - bottom) / free_height, (right_side - left) / free_width) * picture_height / 2;
  } else {
    const double start = -std::min((left - right_side) / (2 * slope_x), (bottom - top) / (2 * slope_y));
    distance = middle + start;  // of the camera from the plane through the middle
  }
  pose.focal_point = (left + right_side) / 2 * right + (bottom + top) / 2 * up + middle * forward;
  pose.position = pose.focal_point - distance * forward;
  return pose;
}

}  // namespace talus
