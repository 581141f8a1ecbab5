#include "contact/narrow/polygon_overlap.hpp"

#include <algorithm>

namespace talus {
namespace {

/// Area and centroid; a polygon without an area is left empty. Measured from one corner: far from the origin nothing is
/// lost.
Vec2 measure(OverlapPolygon& p) {
  const Vec2 origin = p.corners[0];
  Vec2 sum = Vec2::Zero();
  double twice_area = 0;
  for (int i = 1; i + 1 < p.count; ++i) {
    const Vec2 a = p.corners[i] - origin, b = p.corners[i + 1] - origin;
    twice_area += cross(a, b);
    sum += cross(a, b) * (a + b) / 3;
  }
  p.area = twice_area / 2;
  if (!(p.area > 0)) p.count = 0;
  return origin + sum / twice_area;
}

void drop_doubled_corners(OverlapPolygon& p, double same_corner) {
  double perimeter = 0;
  for (int i = 0; i < p.count; ++i) perimeter += (p.corners[(i + 1) % p.count] - p.corners[i]).norm();
  const auto doubled = [&](const Vec2& a, const Vec2& b) { return !((a - b).norm() > same_corner * perimeter); };
  int kept = 0;
  for (int i = 0; i < p.count; ++i)
    if (kept == 0 || !doubled(p.corners[i], p.corners[kept - 1])) p.corners[kept++] = p.corners[i];
  while (kept > 1 && doubled(p.corners[kept - 1], p.corners[0])) --kept;
  p.count = kept;
}

}  // namespace

OverlapPolygon overlap(const Triangle2& a, const Triangle2& b, const ContactTolerances& tolerances) {
  OverlapPolygon p;
  p.count = 3;
  for (int k = 0; k < 3; ++k) p.corners[k] = a[k];
  for (int k = 0; k < 3 && p.count >= 3; ++k) {  // cut off what lies outside of each side of b
    const Vec2 along = b[(k + 1) % 3] - b[k];
    OverlapPolygon inside;
    for (int i = 0; i < p.count; ++i) {
      const Vec2 &s = p.corners[i], &e = p.corners[(i + 1) % p.count];
      const double ds = cross(along, s - b[k]), de = cross(along, e - b[k]);
      // Each cut adds a corner, so that six of nine are used. Rounding may make a sliver not quite convex; a few more
      // corners of it than that would have no area, and may be left out.
      if (inside.count + 2 > static_cast<int>(inside.corners.size())) break;
      if (ds >= 0) inside.corners[inside.count++] = s;
      if ((ds >= 0) != (de >= 0)) inside.corners[inside.count++] = s + (e - s) * (ds / (ds - de));
    }
    p = inside;
  }
  distribute_area(p, tolerances);
  return p;
}

void distribute_area(OverlapPolygon& p, const ContactTolerances& tolerances) {
  const Vec2 centroid = measure(p);
  if (p.count == 0) return;
  drop_doubled_corners(p, tolerances.same_corner);
  if (p.count < 3) {  // a sliver that is hardly there
    p.weights.fill(p.area / p.count);
    return;
  }
  std::array<double, 9> sector{};  // twice the area between the centroid and the side that follows a corner
  for (int i = 0; i < p.count; ++i) {
    const Vec2 &corner = p.corners[i], &next = p.corners[(i + 1) % p.count];
    sector[i] = std::max(cross(corner - centroid, next - centroid), tolerances.least_sector * p.area);
  }
  double sum = 0;
  for (int i = 0; i < p.count; ++i) {
    const int before = (i + p.count - 1) % p.count, after = (i + 1) % p.count;
    const Vec2& corner = p.corners[i];
    const double tip = std::max(0.0, cross(corner - p.corners[before], p.corners[after] - corner));
    p.weights[i] = tip / sector[before] * (p.area / sector[i]);
    sum += p.weights[i];
  }
  for (int i = 0; i < p.count; ++i) p.weights[i] *= p.area / sum;
}

}  // namespace talus
