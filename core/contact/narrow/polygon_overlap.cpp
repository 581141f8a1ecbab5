#include "contact/narrow/polygon_overlap.hpp"

#include <algorithm>

namespace talus {
namespace {

/// Area and centroid; a polygon without an area is left empty. Measured from one corner: far from the origin nothing is
/// lost.
Vec2 measure(OverlapPolygon& p) {
  if (p.corners.size() < 3) {
    p.corners.clear();
    return Vec2::Zero();
  }
  const Vec2 origin = p.corners[0];
  Vec2 sum = Vec2::Zero();
  double twice_area = 0;
  for (std::size_t i = 1; i + 1 < p.corners.size(); ++i) {
    const Vec2 a = p.corners[i] - origin, b = p.corners[i + 1] - origin;
    twice_area += cross(a, b);
    sum += cross(a, b) * (a + b) / 3;
  }
  p.area = twice_area / 2;
  if (!(p.area > 0)) p.corners.clear();
  return origin + sum / twice_area;
}

void drop_doubled_corners(std::vector<Vec2>& corners, double same_corner) {
  double perimeter = 0;
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) perimeter += (corners[(i + 1) % count] - corners[i]).norm();
  const auto doubled = [&](const Vec2& a, const Vec2& b) { return !((a - b).norm() > same_corner * perimeter); };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i)
    if (kept == 0 || !doubled(corners[i], corners[kept - 1])) corners[kept++] = corners[i];
  while (kept > 1 && doubled(corners[kept - 1], corners[0])) --kept;
  corners.resize(kept);
}

}  // namespace

void overlap(std::span<const Vec2> a, std::span<const Vec2> b, const ContactTolerances& tolerances, OverlapPolygon& p) {
  p.corners.assign(a.begin(), a.end());
  for (std::size_t k = 0; k < b.size() && p.corners.size() >= 3; ++k) {  // cut off what lies outside of each side of b
    const Vec2 along = b[(k + 1) % b.size()] - b[k];
    p.cut.clear();
    const std::size_t count = p.corners.size();
    double ds = cross(along, p.corners[0] - b[k]);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 &s = p.corners[i], &e = p.corners[(i + 1) % count];
      const double de = cross(along, e - b[k]);
      if (ds >= 0) p.cut.push_back(s);
      if ((ds >= 0) != (de >= 0)) p.cut.push_back(s + (e - s) * (ds / (ds - de)));
      ds = de;
    }
    p.corners.swap(p.cut);
  }
  distribute_area(p, tolerances);
}

void distribute_area(OverlapPolygon& p, const ContactTolerances& tolerances) {
  p.area = 0;
  const Vec2 centroid = measure(p);
  if (p.corners.empty()) return;
  drop_doubled_corners(p.corners, tolerances.same_corner);
  const std::size_t count = p.corners.size();
  if (count < 3) {  // a sliver that is hardly there
    p.weights.assign(count, p.area / static_cast<double>(count));
    return;
  }
  p.weights.resize(count);
  p.sectors.resize(count);  // twice the area between the centroid and the side that follows a corner
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 &corner = p.corners[i], &next = p.corners[(i + 1) % count];
    p.sectors[i] = std::max(cross(corner - centroid, next - centroid), tolerances.least_sector * p.area);
  }
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count, after = (i + 1) % count;
    const Vec2& corner = p.corners[i];
    const double tip = std::max(0.0, cross(corner - p.corners[before], p.corners[after] - corner));
    p.weights[i] = tip / p.sectors[before] * (p.area / p.sectors[i]);
    sum += p.weights[i];
  }
  for (double& weight : p.weights) weight *= p.area / sum;
}

}  // namespace talus
