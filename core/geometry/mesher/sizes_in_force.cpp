#include "geometry/mesher/sizes_in_force.hpp"

#include <gmsh.h>

#include "mesh/size_field.hpp"

namespace talus {

SizesInForce::SizesInForce(double size, std::span<const MeshRefinement> refinements) {
  gmsh::option::setNumber("Mesh.MeshSizeMax", largest_size(size, refinements));
  if (refinements.empty()) return;
  gmsh::model::mesh::setSizeCallback([size, refinements](int, int, double x, double y, double z) {
    return size_at({x, y, z}, size, refinements);
  });
}

SizesInForce::~SizesInForce() { gmsh::model::mesh::removeSizeCallback(); }

}  // namespace talus
