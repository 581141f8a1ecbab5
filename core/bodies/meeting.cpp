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

void MeetingForces::add(const RigidPair::State& state, const Meeting& place, const Vec3& force, Arms arms) {
  const Meeting::Levers& at = place.levers(state);
  const Vec3 on_first = place.weight() * force;
  any_ = true;
  force_ += on_first;
  first_moment_ +=
      arms == Arms::mean ? at.first.cross(on_first) : at.end.cross(state.half_turned.transpose() * on_first);
  second_moment_ -= at.second.cross(on_first);
}

MeetingForces::Forces MeetingForces::on_parts(const RigidPair& pair, const RigidPair::State& state, Arms arms) const {
  const bool mean = arms == Arms::mean;
  const Vec3 on_first = mean ? force_ : Vec3(state.half_turned.transpose() * force_);
  const Vec3 second =
      mean ? Vec3(second_moment_ / pair.second_radius()) : Vec3(state.tangent.transpose() * second_moment_);
  return {on_first, -on_first, first_moment_ / pair.first_radius(), second};
}

}  // namespace talus
