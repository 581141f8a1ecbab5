#pragma once

#include <array>

#include "base/vector.hpp"
#include "model/tolerances.hpp"

namespace talus {

using Triangle = std::array<Vec3, 3>;

/// The common plane of two facets (Cundall 1988): the plane between them that leaves the largest gap.
struct CommonPlane {
  Vec3 normal;     ///< unit, from the second facet to the first
  double gap;      ///< m, negative where the facets cross
  int iterations;  ///< searches for the closest vertices
  bool converged;  ///< the last one found no better plane; else their number was used up, and the best one so far is
                   ///< this
};

/// Fast common plane of two triangles (paper, 3.1; Nezami et al. 2004): candidate planes of four types are built on the
/// closest pair of vertices (perpendicular to the segment between them; to its part across an edge; parallel to an edge
/// of each; parallel to a facet). The one with the largest gap wins, and its closest vertices are the next pair.
/// The gap never exceeds the distance of the facets, and equals it where they are apart. Where they cross, only the
/// planes parallel to a facet or to an edge of each count.
///
/// Facets of bodies have an inside: given `outward` = (outward normal of b) − (outward normal of a), planes whose
/// normal points against it do not count. Facets that lie in each other, face to face, would else seem to be apart on
/// their wrong sides. With `outward` zero all planes count.
CommonPlane common_plane(const Triangle& a, const Triangle& b, const Vec3& outward,
                         const ContactTolerances& tolerances);

}  // namespace talus
