#pragma once

#include <vector>

#include "geometry/mesher/surfaces/polygon_soup.hpp"
#include "geometry/mesher/surfaces/triangle_solid.hpp"
#include "geometry/surface_finding.hpp"

namespace talus {

/// A surface as far as it could be mended, and what was found in it. It is a TriangleSolid's unless a finding
/// `is_fatal`.
struct MendedSurface {
  TriangleSolid surface;
  std::vector<SurfaceFinding> findings;
};

/// Makes a closed surface that looks outwards of the polygons: vertices in one place are joined, faces without area
/// and double ones left out, sheets that meet in a line or a point taken apart, holes of up to a tenth of the whole
/// filled, faces turned (a body within another one is a cavity of it). Holes that are larger and faces that cross each
/// other are told, not mended.
MendedSurface mended(const PolygonSoup& soup);

}  // namespace talus
