#include "bodies/meeting.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "bodies/finite_rotation.hpp"

namespace talus {

Meeting::Meeting(const BodySet& set, const Side& first, const Side& second) : weight_(first.weight), arm_(first.arm) {
  const RigidBody &a = set.rigid[set.bodies[first.body].rigid], &b = set.rigid[set.bodies[second.body].rigid];
  first_radius_ = a.radius;
  second_radius_ = b.radius;
  apart_ = set.nodes.position[a.centre] - set.nodes.position[b.centre];
  dof_blocks_ = {set.nodes.dof_block[a.centre], set.nodes.dof_block[b.centre], a.rotation_dof_block,
                 b.rotation_dof_block};
  state_.unknowns.fill(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
}

int Meeting::carrier(std::span<const double> weights) {
  const auto first = std::count_if(weights.begin(), weights.end(), [](double weight) { return weight > 0; });
  const auto second = static_cast<std::ptrdiff_t>(weights.size()) - first;
  return first != 1 && second == 1 ? 1 : 0;
}

const Meeting::State& Meeting::at(const Increment& d) const {
  bool same = true;
  for (int k = 0; k < part_count && same; ++k) same = d.segment<3>(3 * dof_blocks_[k]) == state_.unknowns[k];
  if (same) return state_;
  for (int k = 0; k < part_count; ++k) state_.unknowns[k] = d.segment<3>(3 * dof_blocks_[k]);
  const Vec3 theta = state_.unknowns[first_turn] / first_radius_;
  state_.turn = cayley_vector(state_.unknowns[second_turn] / second_radius_);
  state_.first_arm = arm_ + turn_of(theta, arm_);
  state_.first_lever = 0.5 * (arm_ + state_.first_arm);
  state_.second_lever =
      apart_ + 0.5 * (state_.unknowns[first_centre] - state_.unknowns[second_centre]) + state_.first_lever;
  return state_;
}

Vec3 Meeting::increment(const Increment& d) const {
  const State& s = at(d);
  return weight_ *
         (s.unknowns[first_centre] + s.first_arm - arm_ - s.unknowns[second_centre] - s.turn.cross(s.second_lever));
}

void Meeting::add_force(const Increment& d, const Vec3& force, Arms arms, Eigen::VectorXd& sum) const {
  if (arms == Arms::end) {
    const Slope slope = this->slope(d);
    for (int k = 0; k < part_count; ++k) sum.segment<3>(3 * dof_blocks_[k]) += slope.place[k].transpose() * force;
    return;
  }
  const State& s = at(d);
  const Vec3 on_first = weight_ * force;
  sum.segment<3>(3 * dof_blocks_[first_centre]) += on_first;
  sum.segment<3>(3 * dof_blocks_[second_centre]) -= on_first;
  sum.segment<3>(3 * dof_blocks_[first_turn]) += s.first_lever.cross(on_first) / first_radius_;
  sum.segment<3>(3 * dof_blocks_[second_turn]) -= s.second_lever.cross(on_first) / second_radius_;
}

Meeting::Slope Meeting::slope(const Increment& d) const {
  const State& s = at(d);
  const double w = weight_;
  const Mat3 turn = cross_matrix(s.turn), lever = cross_matrix(s.second_lever);
  Slope slope;
  slope.place[first_centre] = w * (Mat3::Identity() - 0.5 * turn);
  slope.place[second_centre] = -slope.place[first_centre];
  slope.place[first_turn] = -1 / first_radius_ * slope.place[first_centre] * cross_matrix(s.first_arm);
  slope.place[second_turn] = w / second_radius_ * lever * cayley_tangent(s.turn);
  slope.levers[first_centre] = w * Mat3::Identity();
  slope.levers[second_centre] = -w * Mat3::Identity();
  slope.levers[first_turn] = w / first_radius_ * cross_matrix(s.first_lever);
  slope.levers[second_turn] = -w / second_radius_ * lever;
  return slope;
}

std::array<Meeting::Turning, 4> Meeting::turning(const Increment& d, const Vec3& force) const {
  const State& s = at(d);
  const Mat3 across = weight_ * cross_matrix(force);
  const Mat3 turned = -0.5 / first_radius_ * across * cross_matrix(s.first_arm);
  return {{{first_turn, first_turn, -turned / first_radius_},
           {second_turn, first_turn, turned / second_radius_},
           {second_turn, first_centre, 0.5 / second_radius_ * across},
           {second_turn, second_centre, -0.5 / second_radius_ * across}}};
}

}  // namespace talus
