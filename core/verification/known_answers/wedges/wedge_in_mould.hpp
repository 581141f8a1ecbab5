#pragma once

#include <array>
#include <vector>

#include "verification/known_answers/support/scene.hpp"
#include "verification/known_answers/wedges/wedge_equilibrium.hpp"

namespace talus {

/// A tetrahedral wedge in its own frame: the line of its planes runs from the back apex down along +x, the top is
/// horizontal, the front vertical. Plane 1 is apex, foot, side 1 (at −y), plane 2 is apex, foot, side 2.
struct WedgeShape {
  Vec3 apex, foot, side_1, side_2;  ///< m

  double length() const { return foot.x() - apex.x(); }
  WedgePlanes planes() const;
};

/// The wedge that two planes, by their upward normals, cut from a bench `length` [m] long, with its apex in the origin.
/// The normals' horizontal parts must lie on either side of +x and their line dip along it.
WedgeShape wedge_between(const Vec3& normal_1, const Vec3& normal_2, double length);

/// A closed surface, its triangles counter-clockwise seen from outside.
struct ClosedSurface {
  std::vector<Vec3> nodes;
  std::vector<std::array<int, 3>> triangles;
};

/// The block that the wedge lies in: a box with a notch that is the wedge, open at the front and at the top. Not
/// convex.
ClosedSurface mould(const WedgeShape& wedge);

/// The wedge (block 1) meshed, `refinements` times eight tetrahedra for one, in its fixed mould (block 0), both turned
/// by `turn`; no stages.
CaseScene wedge_in_mould(const WedgeShape& wedge, const Mat3& turn, const Material& rock, const Joint& planes,
                         int refinements);

/// The planes after a turn.
WedgePlanes turned(const WedgePlanes& planes, const Mat3& turn);

}  // namespace talus
