#include "bodies/meeting.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace talus {

int Meeting::carrier(std::span<const double> weights) {
  const auto first = std::count_if(weights.begin(), weights.end(), [](double weight) { return weight > 0; });
  const auto second = static_cast<std::ptrdiff_t>(weights.size()) - first;
  return first != 1 && second == 1 ? 1 : 0;
}

const Meeting::Levers& Meeting::levers(const RigidPair::State& pair) const {
  if (number_ == pair.number) return levers_;
  number_ = pair.number;
  levers_.end = arm_ + pair.first_turn * arm_;
  levers_.first = 0.5 * (arm_ + levers_.end);
  levers_.second = pair.mean_apart + levers_.first;
  return levers_;
}

Vec3 Meeting::increment(const RigidPair::State& pair) const {
  return weight_ * (pair.apart + pair.first_turn * arm_ - pair.second_turn.cross(levers(pair).second));
}

void Meeting::add_force(const RigidPair& pair, const RigidPair::State& state, const Vec3& force, Arms arms,
                        Eigen::VectorXd& sum) const {
  const Levers& at = levers(state);
  const Vec3 on_first = weight_ * force;
  const auto add = [&](RigidPair::Part part, const Vec3& value) {
    sum.segment<3>(3 * pair.dof_blocks()[part]) += value;
  };
  if (arms == Arms::mean) {
    add(RigidPair::first_centre, on_first);
    add(RigidPair::second_centre, -on_first);
    add(RigidPair::first_turn, at.first.cross(on_first) / pair.first_radius());
    add(RigidPair::second_turn, -at.second.cross(on_first) / pair.second_radius());
    return;
  }
  const Vec3 moved = state.half_turned.transpose() * on_first;
  add(RigidPair::first_centre, moved);
  add(RigidPair::second_centre, -moved);
  add(RigidPair::first_turn, at.end.cross(moved) / pair.first_radius());
  add(RigidPair::second_turn, -state.tangent.transpose() * at.second.cross(on_first));
}

}  // namespace talus
