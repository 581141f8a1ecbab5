#include "contact/contact_point.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace talus {

bool comes_before(const ContactPoint& p, const ContactPoint& q) {
  const auto place = [](const ContactPoint& point) {
    const auto [low, high] = std::minmax(point.bodies[0], point.bodies[1]);
    return std::tuple(low, high, point.bodies[0], point.key);
  };
  return place(p) < place(q);
}

void ContactSet::clear() {
  points.clear();
  nodes.clear();
  weights.clear();
  loose.clear();
  bonded.clear();
  sheared.clear();
  by_key.clear();
}

void ContactSet::sort_out() {
  loose.clear();
  bonded.clear();
  sheared.clear();
  by_key.resize(points.size());
  std::iota(by_key.begin(), by_key.end(), 0);
  std::ranges::sort(by_key, {}, [this](int i) { return points[i].key; });
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const ContactPoint& p = points[i];
    (p.bonded ? bonded : loose).push_back(i);
    if (p.friction > 0 || (p.bonded && p.cohesion > 0)) sheared.push_back(i);
  }
}

}  // namespace talus
