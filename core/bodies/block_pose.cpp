#include "bodies/block_pose.hpp"

#include <Eigen/LU>

#include "bodies/polar.hpp"

namespace talus {

PoseFit::Shape PoseFit::shape_of(const Block& block) {
  Shape shape;
  shape.fixed = block.body == BodyKind::fixed;
  const TetMesh& mesh = block.mesh;
  if (mesh.tetrahedra.empty()) return shape;
  shape.moments = volume_moments(mesh);
  shape.weight.assign(mesh.nodes.size(), 0);
  for (const auto& nodes : mesh.tetrahedra) {
    Mat3 edges;
    for (int i = 0; i < 3; ++i) edges.col(i) = mesh.nodes[nodes[i + 1]] - mesh.nodes[nodes[0]];
    for (const int node : nodes) shape.weight[node] += edges.determinant() / 24 / shape.moments.volume;
  }
  return shape;
}

PoseFit::PoseFit(const BlockSystem& system) {
  for (const Block& block : system.blocks) shapes_.push_back(shape_of(block));
}

BlockPose PoseFit::pose(const BodySet& set, int block) const {
  const Body& body = set.bodies[block];
  const Shape& shape = shapes_[block];
  const Vec3* reference = set.nodes.reference.data() + body.first_node;
  const Vec3* position = set.nodes.position.data() + body.first_node;
  BlockPose pose;
  if (shape.fixed || shape.weight.empty()) {
    pose.centroid = shape.moments.centroid + position[0] - reference[0];
    return pose;
  }
  for (std::size_t n = 0; n < shape.weight.size(); ++n) pose.centroid += shape.weight[n] * position[n];
  Mat3 covariance = Mat3::Zero();
  for (std::size_t n = 0; n < shape.weight.size(); ++n)
    covariance += shape.weight[n] * (position[n] - pose.centroid) * (reference[n] - shape.moments.centroid).transpose();
  pose.rotation = rotation_of(covariance);
  return pose;
}

std::vector<BlockPose> PoseFit::poses(const BodySet& set) const {
  std::vector<BlockPose> poses;
  for (std::size_t b = 0; b < shapes_.size(); ++b) poses.push_back(pose(set, static_cast<int>(b)));
  return poses;
}

}  // namespace talus
