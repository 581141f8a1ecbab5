#include "contact/overlap.hpp"

namespace talus {

OverlapPolygon overlap(const Triangle2& a, const Triangle2& b) {
  OverlapPolygon p;
  p.count = 3;
  for (int k = 0; k < 3; ++k) p.corners[k] = a[k];
  for (int k = 0; k < 3 && p.count >= 3; ++k) {  // cut off what lies outside of each side of b
    const Vec2 along = b[(k + 1) % 3] - b[k];
    OverlapPolygon inside;
    for (int i = 0; i < p.count; ++i) {
      const Vec2 &s = p.corners[i], &e = p.corners[(i + 1) % p.count];
      const double ds = cross(along, s - b[k]), de = cross(along, e - b[k]);
      if (inside.count + 2 > static_cast<int>(inside.corners.size())) break;
      if (ds >= 0) inside.corners[inside.count++] = s;
      if ((ds >= 0) != (de >= 0)) inside.corners[inside.count++] = s + (e - s) * (ds / (ds - de));
    }
    p = inside;
  }
  share_area(p);
  return p;
}

void share_area(OverlapPolygon& p) {
  std::array<double, 9> along{};  // a corner's part of the perimeter
  double perimeter = 0;
  for (int i = 0; i < p.count; ++i) {
    const int j = (i + 1) % p.count;
    const double length = (p.corners[j] - p.corners[i]).norm();
    along[i] += length / 2;
    along[j] += length / 2;
    perimeter += length;
  }
  if (p.count < 3 || !(perimeter > 0)) {
    p.count = 0;
    return;
  }
  Vec2 centre = Vec2::Zero();
  for (int i = 0; i < p.count; ++i) centre += (along[i] / perimeter) * (p.corners[i] - p.corners[0]);
  centre += p.corners[0];
  p.area = 0;
  p.weights.fill(0);
  for (int i = 0; i < p.count; ++i) {
    const int j = (i + 1) % p.count;
    const double sector = cross(p.corners[i] - centre, p.corners[j] - centre) / 2;
    p.area += sector;
    p.weights[i] += sector / 3;
    p.weights[j] += sector / 3;
  }
  for (int i = 0; i < p.count; ++i) p.weights[i] += along[i] / perimeter * p.area / 3;
  if (!(p.area > 0)) p.count = 0;
}

}  // namespace talus
