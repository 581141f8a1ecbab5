#include "orientation/cut_moves.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace talus {
namespace {

Vec3 to_millimetres(const Vec3& point) { return (point * 1e3).array().round() * 1e-3; }

/// Columns: down the plane, along it, and its upward normal.
Mat3 axes_of(const PlaneAttitude& plane) {
  const Vec3 down = dip_vector_of(plane), up = -pole_of(plane);
  Mat3 axes;
  axes << down, up.cross(down), up;
  return axes;
}

/// Where the project file lets the plane of a joint that ends go through.
void pass_through_middle(Cut& cut) {
  if (cut.disc) cut.through = cut.disc->centre;
  if (cut.network) cut.through = (cut.network->box.min + cut.network->box.max) / 2;
  if (cut.polygon.empty()) return;
  cut.through = Vec3::Zero();
  for (const Vec3& corner : cut.polygon) cut.through += corner / static_cast<double>(cut.polygon.size());
}

}  // namespace

Vec3 normal_of(const Cut& cut) { return -pole_of({cut.dip, cut.dip_direction}); }

Cut moved(Cut cut, double along_normal) {
  const Vec3 by = along_normal * normal_of(cut);
  cut.through = to_millimetres(cut.through + by);
  if (cut.disc) cut.disc->centre = to_millimetres(cut.disc->centre + by);
  for (Vec3& corner : cut.polygon) corner = to_millimetres(corner + by);
  if (cut.network) {
    cut.network->box.min = to_millimetres(cut.network->box.min + by);
    cut.network->box.max = to_millimetres(cut.network->box.max + by);
  }
  pass_through_middle(cut);
  return cut;
}

Cut turned(Cut cut, const PlaneAttitude& to, const Vec3& pivot) {
  const Mat3 turn = axes_of(to) * axes_of({cut.dip, cut.dip_direction}).transpose();
  const auto carried = [&](const Vec3& point) { return to_millimetres(pivot + turn * (point - pivot)); };
  cut.dip = to.dip;
  cut.dip_direction = to.dip_direction;
  if (cut.disc) cut.disc->centre = carried(cut.disc->centre);
  for (Vec3& corner : cut.polygon) corner = carried(corner);
  cut.through = to_millimetres(pivot);
  pass_through_middle(cut);
  return cut;
}

Cut with_corner(Cut cut, std::size_t corner, const Vec3& place) {
  const Vec3 normal = normal_of(cut);
  cut.polygon.at(corner) = to_millimetres(place - normal.dot(place - cut.through) * normal);
  pass_through_middle(cut);
  return cut;
}

}  // namespace talus
