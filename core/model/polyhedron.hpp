#pragma once

#include "model/place.hpp"
#include "model/project.hpp"

namespace talus {

/// m³, by the divergence theorem over the faces; negative when the faces are counter-clockwise seen from inside.
double signed_volume(const PolyhedronShape& shape);

/// m², Newell's normal of a face: length is twice the area, stable for polygons of any shape. Taken about the first
/// vertex so that a model far from the origin loses no digits.
Vec3 doubled_area(const PolyhedronShape& shape, const std::vector<int>& face);

/// Checks that the faces are plane polygons that close around a volume and look outwards: vertex numbers in range,
/// no vertex twice, no face without area, planar within 1e-5 of the largest extent, every edge used by two faces in
/// opposite directions, positive volume. Throws InputError at `place` or below it.
void validate_polyhedron(const PolyhedronShape& shape, const Place& place);

}  // namespace talus
