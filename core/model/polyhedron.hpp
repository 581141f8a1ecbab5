#pragma once

#include "model/place.hpp"
#include "model/project.hpp"

namespace talus {

/// m³, by the divergence theorem over the faces; negative when the faces are counter-clockwise seen from inside.
double signed_volume(const PolyhedronShape& shape);

/// Checks that the faces are plane polygons that close around a volume and look outwards: vertex numbers in range,
/// no vertex twice, no face without area, planar within 1e-5 of the largest extent, every edge used by two faces in
/// opposite directions, positive volume. Throws InputError at `place` or below it.
void validate_polyhedron(const PolyhedronShape& shape, const Place& place);

}  // namespace talus
