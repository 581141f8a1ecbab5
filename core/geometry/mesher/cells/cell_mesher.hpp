#pragma once

#include <span>
#include <string>

#include "geometry/mesher/cells/block_skin.hpp"
#include "geometry/mesher/cells/cell_solid.hpp"
#include "geometry/mesher/tet_mesher.hpp"

namespace talus {

/// A block of cells from its corners alone, without gmsh: its skin, and tetrahedra that fill it for its volume and
/// inertia. They meet in its centroid where that sees all of the skin; else they are those of its cells, with nodes of
/// their own inside. Throws TouchesItself at `place` for a block that touches itself along an edge.
MeshedShape coarse_mesh(const CellSolid& solid, std::span<const int> cells, const std::string& place);

/// The skin of a block as finely as the size says, to be filled with tetrahedra. Throws as `block_skin`.
SurfaceMesh fine_surface(const CellSolid& solid, std::span<const int> cells, const SkinSize& size,
                         const std::string& place);

}  // namespace talus
