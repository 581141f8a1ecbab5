#include "verification/random/node_laws.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mesh/moments.hpp"
#include "model/number_text.hpp"

namespace talus {

namespace {

bool may_move(const Block& block) { return block.body != BodyKind::fixed; }

/// The node of a block that is the farthest out by `distance_out(position)` [m], and when.
struct Farthest {
  double distance = 0;  ///< m
  double time = 0;      ///< s
  int block = -1;

  std::string words(const Trajectory& trajectory, const std::string& where) const {
    return "a node of " + trajectory.system.blocks[block].name + " is " + significant(distance) + " m " + where +
           " at " + significant(time, 4) + " s";
  }
};

/// The first moment at which a node is farther out than allowed; block −1: never.
template <typename DistanceOut>
Farthest first_out(const Trajectory& trajectory, double allowance, const DistanceOut& distance_out,
                   const std::string& only = {}) {
  for (std::size_t s = 0; s < trajectory.nodes.size(); ++s) {
    Farthest farthest;
    std::size_t node = 0;
    for (std::size_t b = 0; b < trajectory.system.blocks.size(); ++b) {
      const Block& block = trajectory.system.blocks[b];
      const std::size_t end = node + block.mesh.nodes.size();
      if (may_move(block) && (only.empty() || only == block.name))
        for (std::size_t n = node; n < end; ++n)
          if (const double out = distance_out(trajectory.nodes[s].positions[n]);
              out > allowance && out > farthest.distance)
            farthest = {out, trajectory.snapshots[s].time, static_cast<int>(b)};
      node = end;
    }
    if (farthest.block >= 0) return farthest;
  }
  return {};
}

/// Of a block, about a point.
struct Momentum {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();  ///< kg·m/s, kg·m²/s
};

/// Exact for what moves linearly in each tetrahedron: ∫ x × v = V/20 (Σ xᵢ × Σ vᵢ + Σ xᵢ × vᵢ).
Momentum momentum_of(const Block& block, std::size_t first, double density, const NodeStates& now,
                     const std::vector<Vec3>& reference, const Vec3& about) {
  Momentum sum;
  for (const std::array<int, 4>& tetrahedron : block.mesh.tetrahedra) {
    const auto corner = [&](int i) { return first + static_cast<std::size_t>(tetrahedron[i]); };
    const Vec3& origin = reference[corner(0)];
    const double mass =
        density *
        (reference[corner(1)] - origin).cross(reference[corner(2)] - origin).dot(reference[corner(3)] - origin) / 6;
    Vec3 arms = Vec3::Zero(), velocities = Vec3::Zero(), products = Vec3::Zero();
    for (int i = 0; i < 4; ++i) {
      const Vec3 arm = now.positions[corner(i)] - about;
      const Vec3& velocity = now.velocities[corner(i)];
      arms += arm;
      velocities += velocity;
      products += arm.cross(velocity);
    }
    sum.linear += mass / 4 * velocities;
    sum.angular += mass / 20 * (arms.cross(velocities) + products);
  }
  return sum;
}

/// Of all blocks together, and the sums of its lengths.
struct Momenta {
  Momentum sum;
  double linear = 0, angular = 0;  ///< kg·m/s, kg·m²/s
};

Momenta momenta_of(const Trajectory& trajectory, const std::vector<Material>& materials, const NodeStates& now,
                   const Vec3& about) {
  Momenta all;
  std::size_t first = 0;
  for (std::size_t b = 0; b < trajectory.system.blocks.size(); ++b) {
    const Block& block = trajectory.system.blocks[b];
    const Momentum one =
        momentum_of(block, first, materials[block.material].density, now, trajectory.nodes.front().positions, about);
    all.sum.linear += one.linear;
    all.sum.angular += one.angular;
    all.linear += one.linear.norm();
    all.angular += one.angular.norm();
    first += block.mesh.nodes.size();
  }
  return all;
}

Vec3 centroid_of_all(const BlockSystem& system, const std::vector<Material>& materials) {
  Vec3 sum = Vec3::Zero();
  double mass = 0;
  for (const Block& block : system.blocks) {
    const VolumeMoments moments = volume_moments(block.mesh);
    sum += materials[block.material].density * moments.volume * moments.centroid;
    mass += materials[block.material].density * moments.volume;
  }
  return sum / mass;
}

std::string momentum_fault(const Trajectory& trajectory, const std::vector<Material>& materials, double share) {
  const Vec3 about = centroid_of_all(trajectory.system, materials);
  std::vector<Momenta> all;
  double linear = 0, angular = 0;
  for (const NodeStates& now : trajectory.nodes) {
    all.push_back(momenta_of(trajectory, materials, now, about));
    linear = std::max(linear, all.back().linear);
    angular = std::max(angular, all.back().angular);
  }
  double linear_drift = 0, angular_drift = 0;
  for (const Momenta& now : all) {
    linear_drift = std::max(linear_drift, (now.sum.linear - all.front().sum.linear).norm() / linear);
    angular_drift = std::max(angular_drift, (now.sum.angular - all.front().sum.angular).norm() / angular);
  }
  if (linear_drift <= share && angular_drift <= share) return {};
  return "linear momentum drifts by " + significant(linear_drift) + ", angular by " + significant(angular_drift);
}

}  // namespace

HardCaseExpectation nodes_stay_before(const std::string& block, const Vec3& point, const Vec3& normal,
                                      double allowance) {
  const auto fault = [=](const Trajectory& trajectory) -> std::string {
    const auto behind = [&](const Vec3& position) { return -normal.dot(position - point); };
    const Farthest found = first_out(trajectory, allowance, behind, block);
    return found.block < 0 ? "" : found.words(trajectory, "behind it");
  };
  return {block + " stays before the surface that it strikes", fault, FaultKind::lost};
}

HardCaseExpectation nodes_stay_in_box(const Vec3& min, const Vec3& max, double allowance) {
  const auto fault = [=](const Trajectory& trajectory) -> std::string {
    const auto outside = [&](const Vec3& position) {
      return std::max((min - position).maxCoeff(), (position - max).maxCoeff());
    };
    const Farthest found = first_out(trajectory, allowance, outside);
    return found.block < 0 ? "" : found.words(trajectory, "outside it");
  };
  return {"nothing leaves the box", fault, FaultKind::lost};
}

HardCaseExpectation nodes_stay_above(const std::string& surface, const std::function<double(const Vec3&)>& depth,
                                     double allowance) {
  const auto fault = [=](const Trajectory& trajectory) -> std::string {
    const Farthest found = first_out(trajectory, allowance, depth);
    return found.block < 0 ? "" : found.words(trajectory, "below " + surface);
  };
  return {"nothing goes below " + surface, fault, FaultKind::lost};
}

HardCaseExpectation is_turned_away(const std::string& block, const Vec3& gravity, double share) {
  const auto fault = [=](const Trajectory& trajectory) -> std::string {
    const int index = trajectory.block(block);
    const Vec3 start = trajectory.snapshots.front().blocks[index].velocity;
    const Vec3 free = start + gravity * trajectory.last().time;
    const double change = (trajectory.last().blocks[index].velocity - free).norm() / start.norm();
    return change > share ? "" : "it flies on: its velocity changes by " + significant(change) + " of its speed";
  };
  return {block + " is turned away", fault, FaultKind::lost};
}

HardCaseExpectation momentum_stays(const std::vector<Material>& materials, double share) {
  return {"linear and angular momentum stay within " + significant(share),
          [=](const Trajectory& trajectory) { return momentum_fault(trajectory, materials, share); },
          FaultKind::momentum};
}

}  // namespace talus
