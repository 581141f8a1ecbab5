#include "render/scene/picking.hpp"

#include <Eigen/Geometry>
#include <limits>

namespace talus {

std::optional<RayHit> first_hit(std::span<const BlockActors* const> parts, const Vec3& start, const Vec3& direction) {
  std::optional<RayHit> nearest;
  double nearest_distance = std::numeric_limits<double>::infinity();
  for (const BlockActors* part : parts)
    for (const int t : part->drawn()) {
      const auto& v = part->surface().triangles[t].vertices;
      const Vec3& a = part->positions()[v[0]];
      const Vec3 ab = part->positions()[v[1]] - a, ac = part->positions()[v[2]] - a;
      // Möller and Trumbore (1997): solves start + s·direction = a + u·ab + w·ac.
      const Vec3 p = direction.cross(ac);
      const double determinant = ab.dot(p);
      if (determinant == 0) continue;
      const Vec3 from_a = start - a, q = from_a.cross(ab);
      const double u = from_a.dot(p) / determinant, w = direction.dot(q) / determinant;
      const double distance = ac.dot(q) / determinant;
      if (u < 0 || w < 0 || u + w > 1 || distance < 0 || distance >= nearest_distance) continue;
      nearest_distance = distance;
      nearest = RayHit{part, t, {1 - u - w, u, w}, start + distance * direction};
    }
  return nearest;
}

}  // namespace talus
