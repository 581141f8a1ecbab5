#include "contact/points_by_bodies.hpp"

#include <algorithm>

namespace talus {

void PointsByBodies::sort_entries() { std::sort(entries_.begin(), entries_.end()); }

std::span<const PointsByBodies::Entry> PointsByBodies::of(const std::array<int, 2>& bodies) const {
  const auto before = [](const Entry& e, const std::array<int, 2>& b) { return e.bodies < b; };
  const auto first = std::lower_bound(entries_.begin(), entries_.end(), bodies, before);
  auto last = first;
  while (last != entries_.end() && last->bodies == bodies) ++last;
  return {first, last};
}

}  // namespace talus
