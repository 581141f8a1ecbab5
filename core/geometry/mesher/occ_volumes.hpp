#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "geometry/mesher/surfaces/triangle_solid.hpp"

namespace talus {

/// Of volumes of gmsh's OpenCASCADE model; a box of OpenCASCADE's is wider by its tolerance.
Eigen::AlignedBox3d bounds_of(const std::vector<int>& volumes);
double volume_of(const std::vector<int>& volumes);

/// Points where edges of the volumes meet.
int corner_count(const std::vector<int>& volumes);

/// The volumes as triangles: of flat faces alone their corners, of curved ones as fine as a twentieth of the whole and
/// 36 to the turn.
TriangleSolid tessellated(const std::vector<int>& volumes);

}  // namespace talus
