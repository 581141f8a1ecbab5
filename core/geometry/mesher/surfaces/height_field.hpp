#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/mesher/surfaces/polygon_soup.hpp"
#include "geometry/mesher/surfaces/triangle_solid.hpp"

namespace talus {

/// A surface that each vertical line meets once at most.
struct HeightField {
  std::vector<Vec3> points;                   ///< m
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from above
};

/// The surface over the Delaunay triangulation of points in plan, of as few of them as keep every point within
/// `tolerance` of it vertically (greedy insertion: Garland & Heckbert 1995, "Fast polygonal approximation of terrains
/// and height fields"); of all of them where it is 0. It reaches to their convex hull. Of points in one place the
/// highest counts. Throws InputError at `place` when they lie on one line or are fewer than three.
HeightField height_field(const std::vector<Vec3>& points, double tolerance, const std::string& place);

/// The triangles of a soup as they are; with a tolerance their corners are thinned as above, and the outline is kept.
/// Throws InputError at `place` when the surface has walls or overhangs.
HeightField height_field(const TriangleSoup& soup, double tolerance, const std::string& place);

/// The rock between the surface and the level `base`, m. Throws InputError at `place` when a point lies not above it.
TriangleSolid solid_below(const HeightField& surface, double base, const std::string& place);

}  // namespace talus
