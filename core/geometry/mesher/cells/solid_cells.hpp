#pragma once

#include <string>

#include "geometry/mesher/cells/cell_complex.hpp"
#include "geometry/mesher/polyhedron.hpp"
#include "geometry/mesher/surfaces/triangle_solid.hpp"

namespace talus {

struct SolidCells {
  CellComplex complex;
  int flat_faces = 0;  ///< of the solid: marks of the cells' faces from 0
};

/// A convex polyhedron with flat faces is one cell; faces on one plane have one mark.
SolidCells cells_of(const PolyhedronShape& convex);

/// Convex cells that fill the solid: prisms below the triangles of a terrain, else tetrahedra (gmsh's Delaunay). Faces
/// on the skin have the number of its flat face for a mark. Throws InputError at `place` where it cannot be filled.
SolidCells cells_of(const TriangleSolid& solid, const std::string& place);

}  // namespace talus
