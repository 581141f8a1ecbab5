#pragma once

#include <span>
#include <vector>

#include "base/vector.hpp"
#include "render/paint/painter.hpp"
#include "render/scene/scene.hpp"

namespace talus {

/// Everything a camera has to keep in view: the outermost points in a few hundred directions, so that hundreds of
/// frames can be included at no growing cost. Off by less than 1 % of the size.
class ViewExtent {
 public:
  ViewExtent();
  void include(const Vec3& point) { include(std::span<const Vec3>(&point, 1)); }
  /// Points that lie together: where the box around them does not reach out none of them is looked at.
  void include(std::span<const Vec3> points);
  std::vector<Vec3> points() const;
  bool empty() const { return !any_; }

 private:
  std::vector<Vec3> directions_, outermost_;
  std::vector<double> reach_;
  bool any_ = false;
};

/// Unit vector from the rock to one who stands at `azimuth` (degrees clockwise from north) and `elevation` (up).
Vec3 direction_to_viewer(double azimuth, double elevation);

/// Azimuth and elevation of a named view, degrees.
std::array<double, 2> view_angles(View view);

/// A pose that keeps `look`'s direction, up vector, angle and projection and moves so that all points just fill a free
/// area of the given pixel size in the middle of a picture that is `picture_height` pixels high.
CameraPose fitted(const CameraPose& look, std::span<const Vec3> points, double free_width, double free_height,
                  double picture_height);

}  // namespace talus
