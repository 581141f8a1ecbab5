#pragma once

#include <array>
#include <span>
#include <vector>

#include "contact/found_point.hpp"

namespace talus {

/// Points by the two bodies that they are of, so that whoever looks for those of two bodies need not look at all.
class PointsByBodies {
 public:
  /// Those of `points` that `are_wanted`; the points that are added later are not known.
  template <class AreWanted>
  void sort(std::span<const FoundPoint> points, const AreWanted& are_wanted) {
    entries_.clear();
    for (int i = 0; i < static_cast<int>(points.size()); ++i)
      if (are_wanted(points[i])) entries_.push_back({points[i].bodies, i});
    sort_entries();
  }

  struct Entry {
    std::array<int, 2> bodies;
    int point;
    bool operator<(const Entry& e) const { return bodies != e.bodies ? bodies < e.bodies : point < e.point; }
  };
  /// In the order that they were in.
  std::span<const Entry> of(const std::array<int, 2>& bodies) const;

 private:
  void sort_entries();
  std::vector<Entry> entries_;
};

}  // namespace talus
