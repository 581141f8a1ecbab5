#include "geometry/mesher/cells/joint_planes.hpp"

#include <algorithm>

namespace talus {

JointPlanes::JointPlanes(const Cell& solid, const std::vector<Vec3>& vertices, double reach)
    : solid_(solid), vertices_(vertices), reach_(reach) {
  for (const CellFace& face : solid) {
    auto known = std::ranges::find(planes_, face.mark, &KnownPlane::mark);
    if (known == planes_.end()) {
      const Vec3 normal = area_of(face, vertices).normalized();
      const Vec3& corner = vertices[static_cast<std::size_t>(face.corners.front())];
      known = planes_.insert(known, {face.mark, {0, {}, Plane{normal, normal.dot(corner)}}, -1});
    }
    for (const int corner : face.corners) known->facet.outline.push_back(vertices[static_cast<std::size_t>(corner)]);
  }
}

KnownPlane* JointPlanes::under(const Plane& joint) {
  const auto found =
      std::ranges::find_if(planes_, [&](const KnownPlane& known) { return lies_on(joint, known.facet, reach_); });
  return found == planes_.end() ? nullptr : &*found;
}

void JointPlanes::add(const Plane& joint, int cut, int mark) {
  std::vector<Vec3> outline = section(joint);
  if (!outline.empty()) planes_.push_back({mark, {0, std::move(outline), joint}, cut});
}

/// Where the plane crosses the edges of the solid.
std::vector<Vec3> JointPlanes::section(const Plane& plane) const {
  std::vector<Vec3> points;
  for (const CellFace& face : solid_)
    for (std::size_t k = 0; k < face.corners.size(); ++k) {
      const Vec3& a = vertices_[static_cast<std::size_t>(face.corners[k])];
      const Vec3& b = vertices_[static_cast<std::size_t>(face.corners[(k + 1) % face.corners.size()])];
      const double from = plane.distance(a), to = plane.distance(b);
      if (from * to < 0) points.push_back(a + from / (from - to) * (b - a));
    }
  return points;
}

}  // namespace talus
