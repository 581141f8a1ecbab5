#pragma once

#include <vector>

#include "geometry/mesher/cells/cell_complex.hpp"
#include "geometry/mesher/facet.hpp"

namespace talus {

/// A plane on which facets of a convex solid lie, or a joint.
struct KnownPlane {
  int mark = 0;  ///< of the cells' faces on it
  Facet facet;   ///< of the solid, or where the joint passes through it
  int cut = -1;  ///< that gave it its joint; −1: none did
};

/// The planes of a convex solid, against which a new joint is held: one that lies on a plane but for a splinter is that
/// plane.
class JointPlanes {
 public:
  /// Of a solid that is not looked at: no joint lies on any plane.
  JointPlanes() = default;
  /// `solid`: not cut yet; `reach`: m, within which a joint lies on a facet.
  JointPlanes(const Cell& solid, const std::vector<Vec3>& vertices, double reach);

  /// The plane that a new joint lies on; null: none.
  KnownPlane* under(const Plane& joint);
  void add(const Plane& joint, int cut, int mark);

 private:
  std::vector<Vec3> section(const Plane& plane) const;

  Cell solid_;
  std::vector<Vec3> vertices_;
  double reach_ = 0;
  std::vector<KnownPlane> planes_;
};

}  // namespace talus
