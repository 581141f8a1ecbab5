#include "measures/turning_axes.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>

#include "measures/node_places.hpp"

namespace talus {

namespace {

constexpr double farthest = 2;       // of the block's size
constexpr double slowest = 1e-2;     // of the fastest rate in the frame
constexpr double least_rate = 1e-6;  // rad/s: less is rounding of blocks at rest

bool stands_still(const Block& block, std::size_t number, const Frame& frame) {
  if (block.body == BodyKind::fixed || block.mesh.nodes.size() < 3) return true;
  if (!frame.asleep.empty() && frame.asleep[number] != 0) return true;
  if (frame.motions.empty()) return false;
  const MotionClass& motion = frame.motions[number];
  return motion.mode == MotionMode::stable || motion.came_to_rest;
}

TurningAxis axis_of(const Block& block, int number, std::size_t first, const Frame& frame) {
  const std::vector<Vec3> at = places(block, first, frame);
  const auto count = static_cast<double>(at.size());
  Vec3 middle = Vec3::Zero(), velocity = Vec3::Zero(), moment = Vec3::Zero();
  for (std::size_t n = 0; n < at.size(); ++n) {
    middle += at[n] / count;
    velocity += frame.velocity[first + n] / count;
  }
  Mat3 inertia = Mat3::Zero();
  TurningAxis axis{.block = number};
  for (std::size_t n = 0; n < at.size(); ++n) {
    const Vec3 arm = at[n] - middle;
    moment += arm.cross(frame.velocity[first + n]);
    inertia += arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose();
    axis.size = std::max(axis.size, arm.norm());
  }
  const Vec3 turning = inertia.ldlt().solve(moment);
  axis.rate = turning.norm();
  if (axis.rate >= least_rate) {
    axis.direction = turning / axis.rate;
    axis.point = middle + turning.cross(velocity) / turning.squaredNorm();
  }
  if (axis.rate < least_rate || (axis.point - middle).norm() > farthest * axis.size) axis.rate = 0;
  return axis;
}

}  // namespace

std::vector<TurningAxis> turning_axes(const BlockSystem& system, const Frame& frame) {
  const std::vector<std::size_t> first = first_nodes(system);
  std::vector<TurningAxis> axes;
  double fastest = 0;
  for (std::size_t b = 0; b < system.blocks.size(); ++b) {
    if (stands_still(system.blocks[b], b, frame)) continue;
    axes.push_back(axis_of(system.blocks[b], static_cast<int>(b), first[b], frame));
    fastest = std::max(fastest, axes.back().rate);
  }
  std::erase_if(axes, [&](const TurningAxis& axis) { return !(axis.rate > 0 && axis.rate >= slowest * fastest); });
  return axes;
}

}  // namespace talus
