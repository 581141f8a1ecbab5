#pragma once

#include <string>

#include "geometry/mesher/plane.hpp"
#include "model/project.hpp"

namespace talus {

/// The polyhedron (validated, model/polyhedron.hpp) with exactly flat faces: coordinates rounded to five digits of the
/// longest side are put right, vertices move onto common planes by no more than that; a flat polyhedron comes back
/// unchanged. Throws InputError at `place` when it falls into separate bodies or its faces cannot all be flat.
PolyhedronShape flattened(PolyhedronShape shape, const std::string& place);

/// The same of faces that may be several bodies.
PolyhedronShape with_flat_faces(PolyhedronShape shape, const std::string& place);

/// Whether the polyhedron, of flat faces and one body, is convex, and all of its faces are.
bool is_convex(const PolyhedronShape& shape);

/// m, the plane of a flat face, its normal outwards.
Plane plane_of(const PolyhedronShape& shape, const std::vector<int>& face);

}  // namespace talus
