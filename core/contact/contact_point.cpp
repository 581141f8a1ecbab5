#include "contact/contact_point.hpp"

namespace talus {

void ContactSet::clear() {
  points.clear();
  nodes.clear();
  weights.clear();
  loose.clear();
  bonded.clear();
  sheared.clear();
}

void ContactSet::sort_out() {
  loose.clear();
  bonded.clear();
  sheared.clear();
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const ContactPoint& p = points[i];
    (p.bonded ? bonded : loose).push_back(i);
    if (p.friction > 0 || (p.bonded && p.cohesion > 0)) sheared.push_back(i);
  }
}

}  // namespace talus
