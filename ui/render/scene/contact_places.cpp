#include "render/scene/contact_places.hpp"

#include <Eigen/Geometry>
#include <limits>

#include "render/scene/block_surface.hpp"

namespace talus {

namespace {

/// Weights of a triangle's corners at its point that is nearest to `p`, as good as: those outside are cut off.
Vec3 nearest_weights(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  if (area == 0) return Vec3::UnitX();
  Vec3 weights((c - b).cross(p - b).dot(normal), (a - c).cross(p - c).dot(normal), (b - a).cross(p - a).dot(normal));
  weights = (weights / area).cwiseMax(0);
  return weights / weights.sum();
}

/// Displacement of the surface of a block where it is nearest to a point of the frame, m.
Vec3 displacement_near(const Block& block, std::size_t first_node, const Frame& frame, const Vec3& point) {
  double nearest = std::numeric_limits<double>::infinity();
  Vec3 displacement = Vec3::Zero();
  for (const SurfaceTriangle& triangle : block.surface) {
    std::array<Vec3, 3> moved, at;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto node = static_cast<std::size_t>(triangle.nodes[i]);
      moved[i] = frame.displacement[first_node + node];
      at[i] = block.mesh.nodes[node] + moved[i];
    }
    const Vec3 w = nearest_weights(at[0], at[1], at[2], point);
    const double distance = (w[0] * at[0] + w[1] * at[1] + w[2] * at[2] - point).squaredNorm();
    if (distance >= nearest) continue;
    nearest = distance;
    displacement = w[0] * moved[0] + w[1] * moved[1] + w[2] * moved[2];
  }
  return displacement;
}

}  // namespace

std::vector<Vec3> contact_places(const BlockSystem& system, const Frame& frame, double scale) {
  std::vector<std::size_t> first_node;
  std::size_t nodes = 0;
  for (const Block& block : system.blocks) {
    first_node.push_back(nodes);
    nodes += block.mesh.nodes.size();
  }
  std::vector<Vec3> places;
  for (const ContactSample& contact : frame.contacts) {
    Vec3 displacement = Vec3::Zero();
    if (scale != 1)
      for (const int b : contact.blocks) {
        const auto block = static_cast<std::size_t>(b);
        displacement += 0.5 * displacement_near(system.blocks.at(block), first_node.at(block), frame, contact.position);
      }
    places.push_back(contact.position + (scale - 1) * displacement);
  }
  return places;
}

}  // namespace talus
