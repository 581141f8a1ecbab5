#include "bodies/block_motion.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "bodies/polar.hpp"
#include "model/block_names.hpp"

namespace talus {

namespace {

Mat3 edge_matrix(const std::vector<Vec3>& points, const std::array<int, 4>& nodes) {
  Mat3 edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = points[nodes[i + 1]] - points[nodes[0]];
  return edges;
}

std::array<double, 4> barycentric(const Corners& corners, const Vec3& where) {
  Mat3 edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = corners[i + 1] - corners[0];
  const Vec3 w = edges.inverse() * (where - corners[0]);
  return {1 - w.sum(), w[0], w[1], w[2]};
}

/// Distance of a point from the plane of the face that it lies outside most [m]; not above zero inside.
double outside_by(const Corners& corners, const std::array<double, 4>& weights) {
  const ElementShape shape = element_shape(corners);
  double worst = -1e300;
  for (int i = 0; i < 4; ++i) worst = std::max(worst, -weights[i] / shape.gradient[i].norm());
  return worst;
}

}  // namespace

BlockMotion block_motion(const BodySet& set, int index) {
  const Body& body = set.bodies[index];
  BlockMotion motion;
  if (body.built_fixed()) return motion;
  if (body.kind == BodyKind::rigid) {
    const RigidBody& rigid = set.rigid[body.rigid];
    motion.displacement = set.nodes.position[rigid.centre] - set.nodes.reference[rigid.centre];
    motion.velocity = set.nodes.velocity[rigid.centre];
    motion.rotation = std::abs(Eigen::AngleAxisd(rigid.rotation).angle());
    return motion;
  }
  double volume = 0, mass = 0;
  Mat3 gradient = Mat3::Zero();
  for (const Element& element : set.elements_of(index)) {
    const Mat3 reference = edge_matrix(set.nodes.reference, element.nodes);
    const Mat3 current = edge_matrix(set.nodes.position, element.nodes);
    volume += element.volume_ratio * current.determinant() / 6;
    gradient += reference.determinant() * current * reference.inverse();
    for (const int node : element.nodes) {
      motion.displacement += element.mass / 4 * (set.nodes.position[node] - set.nodes.reference[node]);
      motion.velocity += element.mass / 4 * set.nodes.velocity[node];
    }
    mass += element.mass;
  }
  motion.displacement /= mass;
  motion.velocity /= mass;
  motion.relative_volume_change = volume / body.reference_volume - 1;
  motion.rotation = std::abs(Eigen::AngleAxisd(rotation_of(gradient)).angle());
  return motion;
}

Vec3 place_before_run(const BodySet& set, const Vec3& place, int body) {
  const NodeSet& nodes = set.nodes;
  const Body& block = set.bodies[body];
  int nearest = block.first_node;
  for (int n = block.first_node; n < block.first_node + block.node_count; ++n)
    if ((nodes.position[n] - place).squaredNorm() < (nodes.position[nearest] - place).squaredNorm()) nearest = n;
  return nodes.reference[nearest] + place - nodes.position[nearest];
}

Vec3 MaterialPoint::at(const std::vector<Vec3>& values) const {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 4; ++i) sum += weights[i] * values[nodes[i]];
  return sum;
}

MaterialPoint material_point(const BlockSystem& system, const std::string& name, const Vec3& where, double tolerance,
                             const std::string& place) {
  int first_node = 0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    const Block& block = system.blocks[b];
    if (block.name != name) {
      first_node += static_cast<int>(block.mesh.nodes.size());
      continue;
    }
    MaterialPoint best;
    double best_distance = 1e300;
    for (std::size_t t = 0; t < block.mesh.tetrahedra.size(); ++t) {
      const auto& tetrahedron = block.mesh.tetrahedra[t];
      Corners corners;
      for (int i = 0; i < 4; ++i) corners[i] = block.mesh.nodes[tetrahedron[i]];
      const auto weights = barycentric(corners, where);
      const double distance = outside_by(corners, weights);
      if (distance >= best_distance) continue;
      best_distance = distance;
      best.body = static_cast<int>(b);
      best.tetrahedron = static_cast<int>(t);
      best.weights = weights;
      for (int i = 0; i < 4; ++i) best.nodes[i] = first_node + tetrahedron[i];
    }
    if (best_distance <= tolerance) return best;
    throw point_outside_block(place, name);
  }
  throw InputError(place, "there is no block '" + name + "'", "name one of the blocks that 'talus-cli mesh' lists");
}

}  // namespace talus
