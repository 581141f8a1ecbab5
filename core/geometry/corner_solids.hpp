#pragma once

#include <vector>

#include "model/project.hpp"

namespace talus {

/// Of each solid, whether all of its blocks stand on their corners: a convex polyhedron of which no block is filled
/// with tetrahedra of some size, cut along planes without end. The mesher cuts it as convex cells, without OpenCASCADE.
/// One whose corners are rounded so that it is convex no more is left to the mesher to find out.
std::vector<bool> corner_solids(const Project& project);

}  // namespace talus
