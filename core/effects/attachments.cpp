#include "effects/attachments.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "bodies/finite_rotation.hpp"

namespace talus {

void Attachments::clear() {
  points_.clear();
  shares_.clear();
  turns_.clear();
}

void Attachments::add_share(int first, int freedom, double weight) {
  for (std::size_t i = first; i < shares_.size(); ++i)
    if (shares_[i].freedom == freedom) {
      shares_[i].weight += weight;
      return;
    }
  shares_.push_back({freedom, weight});
}

void Attachments::add_turn(int first, const RigidBody& rigid, int node, double weight) {
  const Vec3 arm = weight * (set_.nodes.position[node] - set_.nodes.position[rigid.centre]);
  for (std::size_t i = first; i < turns_.size(); ++i)
    if (turns_[i].freedom == rigid.rotation_freedom) {
      turns_[i].arm += arm;
      return;
    }
  turns_.push_back({.freedom = rigid.rotation_freedom, .radius = rigid.radius, .arm = arm});
}

void Attachments::add(std::span<const int> nodes, std::span<const double> weights) {
  Point point{static_cast<int>(shares_.size()), 0, static_cast<int>(turns_.size()), 0, Vec3::Zero()};
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const int node = nodes[k];
    const double weight = weights[k];
    const Body& body = set_.bodies[set_.nodes.body[node]];
    if (body.fixed) {
      point.held += weight * set_.nodes.prescribed[node];
    } else if (body.kind == BodyKind::tetrahedra) {
      add_share(point.share_begin, set_.nodes.freedom[node], weight);
    } else if (body.kind == BodyKind::affine) {
      const auto& carried = set_.carried[node - body.first_node + body.first_carried];
      for (int c = 0; c < 4; ++c)
        add_share(point.share_begin, set_.nodes.freedom[body.first_carrier + c], weight * carried[c]);
    } else {
      const RigidBody& rigid = set_.rigid[body.rigid];
      add_share(point.share_begin, set_.nodes.freedom[rigid.centre], weight);
      add_turn(point.turn_begin, rigid, node, weight);
    }
  }
  point.share_end = static_cast<int>(shares_.size());
  point.turn_end = static_cast<int>(turns_.size());
  points_.push_back(point);
}

const Vec3& Attachments::way_of(const Turn& turn, const Increment& d) {
  const auto unknowns = d.segment<3>(3 * turn.freedom);
  if (unknowns == turn.unknowns) return turn.way;
  turn.unknowns = unknowns;
  const Vec3 theta = turn.unknowns / turn.radius;
  const double angle = theta.norm();
  turn.way = turn_of(theta, turn.arm);
  turn.stretch = angle > 0 ? cayley_vector(theta).norm() / angle : 1;
  return turn.way;
}

Vec3 Attachments::lever_at(const Turn& turn, const Increment& d) const {
  const Vec3& way = way_of(turn, d);
  return set_.mean_arms ? Vec3(turn.stretch * (turn.arm + 0.5 * way)) : Vec3(turn.arm + way);
}

Vec3 Attachments::increment(int index, const Increment& d) const {
  const Point& point = points_[index];
  Vec3 u = point.held;
  for (int i = point.share_begin; i < point.share_end; ++i)
    u += shares_[i].weight * d.segment<3>(3 * shares_[i].freedom);
  for (int i = point.turn_begin; i < point.turn_end; ++i) u += way_of(turns_[i], d);
  return u;
}

double Attachments::farthest_against(int index, const Increment& d, const Vec3& direction,
                                     const Eigen::VectorXd& step) const {
  const Point& point = points_[index];
  double sum = 0;
  for (int i = point.share_begin; i < point.share_end; ++i)
    sum += std::min(0.0, shares_[i].weight * direction.dot(step.segment<3>(3 * shares_[i].freedom)));
  for (int i = point.turn_begin; i < point.turn_end; ++i) {
    const Vec3 theta = step.segment<3>(3 * turns_[i].freedom) / turns_[i].radius;
    sum += std::min(0.0, direction.dot(theta.cross(arm_at(turns_[i], d))));
  }
  return sum;
}

void Attachments::join_freedoms(int index, DisjointSets& together) const {
  const Point& point = points_[index];
  int first = -1;
  const auto join = [&](int freedom) {
    if (first < 0) first = freedom;
    together.join(first, freedom);
  };
  for (int i = point.share_begin; i < point.share_end; ++i) join(shares_[i].freedom);
  for (int i = point.turn_begin; i < point.turn_end; ++i) join(turns_[i].freedom);
}

void Attachments::add_force(int index, const Increment& d, const Vec3& force, Eigen::VectorXd& sum) const {
  const Point& point = points_[index];
  for (int i = point.share_begin; i < point.share_end; ++i)
    sum.segment<3>(3 * shares_[i].freedom) += shares_[i].weight * force;
  for (int i = point.turn_begin; i < point.turn_end; ++i)
    sum.segment<3>(3 * turns_[i].freedom) += lever_at(turns_[i], d).cross(force) / turns_[i].radius;
}

void Attachments::add_spring(int index, const Increment& d, const Mat3& spring, SymmetricBlocks& sum) const {
  const Point& point = points_[index];
  for (int a = point.share_begin; a < point.share_end; ++a)
    for (int b = point.share_begin; b <= a; ++b)
      sum.add(shares_[a].freedom, shares_[b].freedom, shares_[a].weight * shares_[b].weight * spring);
  for (int a = point.turn_begin; a < point.turn_end; ++a) {
    const Mat3 turned = cross_matrix(arm_at(turns_[a], d)) * spring / turns_[a].radius;  // (∂u/∂θ)ᵀ spring
    for (int b = point.share_begin; b < point.share_end; ++b)
      sum.add(turns_[a].freedom, shares_[b].freedom, shares_[b].weight * turned);
    for (int b = point.turn_begin; b <= a; ++b)
      sum.add(turns_[a].freedom, turns_[b].freedom, -turned * cross_matrix(arm_at(turns_[b], d)) / turns_[b].radius);
  }
}

void Attachments::add_spring(int index, const Increment& d, const Mat3& spring, UnsymmetricBlocks& sum) const {
  const Point& point = points_[index];
  for (int a = point.share_begin; a < point.share_end; ++a) {
    for (int b = point.share_begin; b < point.share_end; ++b)
      sum.add(shares_[a].freedom, shares_[b].freedom, shares_[a].weight * shares_[b].weight * spring);
    for (int b = point.turn_begin; b < point.turn_end; ++b) {
      const Mat3 arm = cross_matrix(arm_at(turns_[b], d)) / turns_[b].radius;
      sum.add(shares_[a].freedom, turns_[b].freedom, -shares_[a].weight * spring * arm);
      sum.add(turns_[b].freedom, shares_[a].freedom, shares_[a].weight * arm * spring);
    }
  }
  for (int a = point.turn_begin; a < point.turn_end; ++a)
    for (int b = point.turn_begin; b < point.turn_end; ++b)
      sum.add(turns_[a].freedom, turns_[b].freedom,
              -cross_matrix(arm_at(turns_[a], d)) * spring * cross_matrix(arm_at(turns_[b], d)) /
                  (turns_[a].radius * turns_[b].radius));
}

void Attachments::add_lever_difference(int index, const Increment& d, const Mat3& spring,
                                       UnsymmetricBlocks& sum) const {
  if (!set_.mean_arms) return;
  const Point& point = points_[index];
  for (int a = point.turn_begin; a < point.turn_end; ++a) {
    const Turn& turn = turns_[a];
    const Mat3 left = cross_matrix(lever_at(turn, d) - arm_at(turn, d)) * spring / turn.radius;
    for (int b = point.share_begin; b < point.share_end; ++b)
      sum.add(turn.freedom, shares_[b].freedom, shares_[b].weight * left);
    for (int b = point.turn_begin; b < point.turn_end; ++b)
      sum.add(turn.freedom, turns_[b].freedom, -left * cross_matrix(arm_at(turns_[b], d)) / turns_[b].radius);
  }
}

void Attachments::add_turning(int index, const Increment& d, const Vec3& force, UnsymmetricBlocks& sum) const {
  const Point& point = points_[index];
  for (int i = point.turn_begin; i < point.turn_end; ++i) {
    const Turn& turn = turns_[i];
    const Vec3 arm = (set_.mean_arms ? 0.5 * turn.stretch : 1) * arm_at(turn, d);
    sum.add(turn.freedom, turn.freedom,
            (arm * force.transpose() - arm.dot(force) * Mat3::Identity()) / (turn.radius * turn.radius));
  }
}

}  // namespace talus
