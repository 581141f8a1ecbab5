#pragma once

#include <string>
#include <vector>

#include "geometry/mesher/surfaces/triangle_solid.hpp"
#include "model/project.hpp"

namespace talus {

/// A polyhedron with flat faces as a volume of gmsh's OpenCASCADE model; its tag.
int add_polyhedron(const PolyhedronShape& shape);

/// The bodies of a triangulated solid as volumes of gmsh's OpenCASCADE model, a face for each flat part of its
/// surface, with cavities. None when there are more than `most_faces` of those or OpenCASCADE makes another volume of
/// them: it is slow and fails where faces are many and small.
std::vector<int> add_flat_bodies(const TriangleSolid& solid, std::size_t most_faces);

}  // namespace talus
