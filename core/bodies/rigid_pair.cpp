#include "bodies/rigid_pair.hpp"

#include <limits>

#include "bodies/finite_rotation.hpp"

namespace talus {

RigidPair::RigidPair(const BodySet& set, const RigidBody& first, const RigidBody& second)
    : first_radius_(first.radius),
      second_radius_(second.radius),
      apart_(set.nodes.position[first.centre] - set.nodes.position[second.centre]),
      dof_blocks_{set.nodes.dof_block[first.centre], set.nodes.dof_block[second.centre], first.rotation_dof_block,
                  second.rotation_dof_block} {
  unknowns_.fill(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
}

const RigidPair::State& RigidPair::at(const Increment& d) const {
  bool same = true;
  for (int k = 0; k < part_count && same; ++k) same = d.segment<3>(3 * dof_blocks_[k]) == unknowns_[k];
  if (same) return state_;
  for (int k = 0; k < part_count; ++k) unknowns_[k] = d.segment<3>(3 * dof_blocks_[k]);
  ++state_.number;
  state_.apart = unknowns_[first_centre] - unknowns_[second_centre];
  state_.mean_apart = apart_ + 0.5 * state_.apart;
  state_.first_turn = turn_by(unknowns_[first_turn] / first_radius_);
  state_.second_turn = cayley_vector(unknowns_[second_turn] / second_radius_);
  state_.half_turned = Mat3::Identity() - 0.5 * cross_matrix(state_.second_turn);
  state_.tangent = cayley_tangent(state_.second_turn) / second_radius_;
  return state_;
}

}  // namespace talus
