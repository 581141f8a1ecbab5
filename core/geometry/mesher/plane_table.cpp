#include "geometry/mesher/plane_table.hpp"

#include <algorithm>
#include <cmath>

namespace talus {

int PlaneTable::index_of(const Plane& plane, std::span<const Vec3> outline) {
  constexpr double parallel = 1e-6;  // radians; a short facet's points say little about its direction
  const auto same = std::find_if(planes_.begin(), planes_.end(), [&](const Plane& known) {
    return angle_between(known, plane) < parallel &&
           std::all_of(outline.begin(), outline.end(),
                       [&](const Vec3& point) { return std::abs(known.distance(point)) <= rounding_; });
  });
  if (same != planes_.end()) return static_cast<int>(same - planes_.begin());
  planes_.push_back(plane);
  return static_cast<int>(planes_.size()) - 1;
}

}  // namespace talus
