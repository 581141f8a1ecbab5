#include "mesh/mesh_size.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/block.hpp"

namespace talus {

double mesh_size(std::span<const Vec3> nodes, std::span<const SurfaceTriangle> surface) {
  double area = 0;
  for (const SurfaceTriangle& t : surface) {
    const Vec3 p = nodes[t.nodes[0]];
    area += (nodes[t.nodes[1]] - p).cross(nodes[t.nodes[2]] - p).norm() / 2;
  }
  return std::sqrt(2 * area / static_cast<double>(surface.size()));
}

double smallest_mesh_size(const BlockSystem& system) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Block& block : system.blocks)
    if (block.body != BodyKind::fixed) smallest = std::min(smallest, mesh_size(block.mesh.nodes, block.surface));
  return smallest;
}

bool is_needle(double length, double area, double mesh_size) {
  constexpr double very_many = 5000;
  return length > very_many * mesh_size && area < mesh_size * length;
}

}  // namespace talus
