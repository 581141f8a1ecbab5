#include "geometry/mesher/cells/flat_groups.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/mesher/cells/set_numbers.hpp"
#include "geometry/mesher/plane.hpp"

namespace talus {
namespace {

Plane plane_of(const TriangleSolid& solid, int triangle) {
  const auto& corners = solid.triangles[static_cast<std::size_t>(triangle)];
  const auto at = [&](std::size_t k) -> const Vec3& { return solid.vertices[static_cast<std::size_t>(corners[k])]; };
  const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
  return {normal, normal.dot(at(0))};
}

}  // namespace

std::vector<int> flat_groups(const TriangleSolid& solid) {
  constexpr double parallel = 1e-6, rounding = 1e-9;
  const double flat = rounding * bounds_of(solid).diagonal().norm();
  const auto count = static_cast<int>(solid.triangles.size());
  DisjointSets groups;
  groups.reset(count);
  std::map<std::pair<int, int>, int> owner;  // of a directed edge
  for (int t = 0; t < count; ++t) {
    const auto& corners = solid.triangles[static_cast<std::size_t>(t)];
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = corners[k], to = corners[(k + 1) % 3];
      owner.emplace(std::pair(from, to), t);
      const auto across = owner.find({to, from});
      if (across == owner.end()) continue;
      // Against the first of the group, so that a gently bent surface is not taken for flat.
      const Plane first = plane_of(solid, groups.first_of(across->second)), own = plane_of(solid, t);
      const bool same_side = first.normal.dot(own.normal) > 0;
      const bool lies_on = std::all_of(corners.begin(), corners.end(), [&](int corner) {
        return std::abs(first.distance(solid.vertices[static_cast<std::size_t>(corner)])) <= flat;
      });
      if (same_side && lies_on && angle_between(first, own) < parallel) groups.join(across->second, t);
    }
  }
  return set_numbers(groups);
}

}  // namespace talus
