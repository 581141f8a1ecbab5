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
  const int first = set.bodies[block].first_node;
  return pose(block, set.nodes.reference.data() + first, set.nodes.position.data() + first);
}

BlockPose PoseFit::pose(int block, const Vec3* reference, const Vec3* position) const {
  const Shape& shape = shapes_[block];
  BlockPose pose;
  if (shape.fixed || shape.weight.empty()) {
    pose.centroid = shape.moments.centroid + position[0] - reference[0];
    return pose;
  }
  pose.centroid = mean(block, position);
  Mat3 covariance = Mat3::Zero();
  for (std::size_t n = 0; n < shape.weight.size(); ++n)
    covariance += shape.weight[n] * (position[n] - pose.centroid) * (reference[n] - shape.moments.centroid).transpose();
  pose.rotation = rotation_of(covariance);
  return pose;
}

Vec3 PoseFit::mean(int block, const Vec3* nodal) const {
  const Shape& shape = shapes_[block];
  Vec3 sum = Vec3::Zero();
  for (std::size_t n = 0; n < shape.weight.size(); ++n) sum += shape.weight[n] * nodal[n];
  return sum;
}

std::vector<BlockPose> PoseFit::poses(const BodySet& set) const {
  std::vector<BlockPose> poses;
  for (std::size_t b = 0; b < shapes_.size(); ++b) poses.push_back(pose(set, static_cast<int>(b)));
  return poses;
}

}  // namespace talus
