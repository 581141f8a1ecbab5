#pragma once

#include <span>
#include <vector>

#include "geometry/mesher/plane.hpp"

namespace talus {

/// All planes that facets of a model lie on. Facets that lie on one plane but for rounding get the same entry, also
/// when they belong to different solids: nodes put onto it then meet to the last digit.
class PlaneTable {
 public:
  /// `rounding`: m, how far a point may be off a plane by rounding alone.
  explicit PlaneTable(double rounding) : rounding_(rounding) {}

  /// Index of the plane; an entry that all of `outline` lies on is used again.
  int index_of(const Plane& plane, std::span<const Vec3> outline);
  const Plane& operator[](int index) const { return planes_[static_cast<std::size_t>(index)]; }

 private:
  double rounding_;
  std::vector<Plane> planes_;
};

}  // namespace talus
