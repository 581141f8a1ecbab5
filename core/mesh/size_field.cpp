#include "mesh/size_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {

namespace {

double distance_to_side(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 side = to - from;
  const double length = side.squaredNorm();
  const double along = length > 0 ? std::clamp((point - from).dot(side) / length, 0.0, 1.0) : 0;
  return (point - from - along * side).norm();
}

/// Whether the point lies above or below the flat polygon: its foot has an odd number of sides to one hand.
bool is_over(const Vec3& point, const std::vector<Vec3>& corners, const Vec3& normal) {
  const Vec3 right = normal.unitOrthogonal(), up = normal.cross(right);
  bool over = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 from = corners[i] - point, to = corners[(i + 1) % corners.size()] - point;
    const double low = up.dot(from), high = up.dot(to);
    if ((low > 0) == (high > 0)) continue;
    if (right.dot(from) + (right.dot(to) - right.dot(from)) * low / (low - high) > 0) over = !over;
  }
  return over;
}

double distance_to_face(const Vec3& point, const std::vector<Vec3>& corners) {
  Vec3 twice_area = Vec3::Zero();
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 &from = corners[i], &to = corners[(i + 1) % corners.size()];
    twice_area += (from - corners[0]).cross(to - corners[0]);
    nearest = std::min(nearest, distance_to_side(point, from, to));
  }
  if (!(twice_area.norm() > 0)) return nearest;
  const Vec3 normal = twice_area.normalized();
  return is_over(point, corners, normal) ? std::abs(normal.dot(point - corners[0])) : nearest;
}

double distance_to(const MeshRefinement& refinement, const Vec3& point) {
  return refinement.face.empty() ? (point - refinement.at).norm() : distance_to_face(point, refinement.face);
}

}  // namespace

Eigen::AlignedBox3d box_of(const MeshRefinement& refinement) {
  if (refinement.face.empty()) return Eigen::AlignedBox3d(refinement.at, refinement.at);
  Eigen::AlignedBox3d box;
  for (const Vec3& corner : refinement.face) box.extend(corner);
  return box;
}

double size_at(const Vec3& point, double own, std::span<const MeshRefinement> refinements) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const MeshRefinement& refinement : refinements) {
    const double beyond = (distance_to(refinement, point) - refinement.radius) / refinement.radius;
    if (beyond < 1) smallest = std::min(smallest, refinement.size + std::max(0.0, beyond) * (own - refinement.size));
  }
  return smallest < std::numeric_limits<double>::infinity() ? smallest : own;
}

double largest_size(double own, std::span<const MeshRefinement> refinements) {
  double largest = own;
  for (const MeshRefinement& refinement : refinements) largest = std::max(largest, refinement.size);
  return largest;
}

}  // namespace talus
