#include "verification/known_answers/support/surface_loads.hpp"

#include <Eigen/Geometry>

namespace talus {

std::vector<PointLoad> surface_loads(const Block& block, const Traction& traction) {
  std::vector<Vec3> force(block.mesh.nodes.size(), Vec3::Zero());
  for (const SurfaceTriangle& triangle : block.surface) {
    const auto& [a, b, c] = triangle.nodes;
    const Vec3 area =
        0.5 * (block.mesh.nodes[b] - block.mesh.nodes[a]).cross(block.mesh.nodes[c] - block.mesh.nodes[a]);
    const Vec3 centre = (block.mesh.nodes[a] + block.mesh.nodes[b] + block.mesh.nodes[c]) / 3;
    const Vec3 share = area.norm() / 3 * traction(centre, area.normalized());
    for (const int node : triangle.nodes) force[node] += share;
  }
  std::vector<PointLoad> loads;
  for (std::size_t n = 0; n < force.size(); ++n)
    if (force[n] != Vec3::Zero())
      loads.push_back({.block = block.name, .at = block.mesh.nodes[n], .force = force[n], .table = {}});
  return loads;
}

std::vector<Constraint> held_in_place(const std::string& block, const Vec3& origin, const Vec3& along_x,
                                      const Vec3& along_y) {
  return {{.block = block, .at = origin, .displacement = {0, 0, 0}, .table = {}},
          {.block = block, .at = along_x, .displacement = {std::nullopt, 0, 0}, .table = {}},
          {.block = block, .at = along_y, .displacement = {std::nullopt, std::nullopt, 0}, .table = {}}};
}

}  // namespace talus
