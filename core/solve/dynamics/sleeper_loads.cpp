#include "solve/dynamics/sleeper_loads.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace talus {

void SleeperLoads::add(Load& load, const BodySet& set, int body, const Vec3& at, const Vec3& force) {
  load.force += force;
  load.moment += (at - set.nodes.position[set.bodies[body].first_node]).cross(force);
  load.pressing += force.norm();
}

SleeperLoads::Load& SleeperLoads::Load::operator-=(const Load& other) {
  force -= other.force;
  moment -= other.moment;
  pressing -= other.pressing;
  return *this;
}

void SleeperLoads::fall_asleep(std::span<const int> sleepers, const BodySet& set, const ContactSet& contacts,
                               std::span<const ContactOutcome> outcomes) {
  std::vector<char> falls_asleep(sizes_.size(), 0);
  for (const int b : sleepers) {
    falls_asleep[b] = 1;
    of_all_[b] = {};
  }
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const ContactPoint& point = contacts.points[i];
    const Vec3 force = outcomes[i].normal_force * point.normal + outcomes[i].shear_force;
    for (const int side : {0, 1}) {
      const int body = point.bodies[side];
      if (falls_asleep[body]) add(of_all_[body], set, body, point.position, side == 0 ? force : Vec3(-force));
    }
  }
}

void SleeperLoads::set_resting(const BodySet& set, const std::vector<RestingContact>& resting) {
  now_.assign(now_.size(), {});
  for (const RestingContact& contact : resting) {
    const Vec3 force = contact.normal_force * contact.normal + contact.shear_force;
    for (const int side : {0, 1}) {
      const int body = contact.bodies[side];
      add(now_[body], set, body, contact.position, side == 0 ? force : Vec3(-force));
    }
  }
  of_awake_ = of_all_;
  for (std::size_t b = 0; b < sizes_.size(); ++b) of_awake_[b] -= now_[b];
  lean_on_awake_.clear();
  for (int b = 0; b < static_cast<int>(sizes_.size()); ++b)
    if (differ(b, of_awake_[b], {})) lean_on_awake_.push_back(b);
}

bool SleeperLoads::differ(int body, const Load& a, const Load& b) const {
  Load change = a;
  change -= b;
  const double sum = change.force.norm() + change.moment.norm() / sizes_[body] + std::abs(change.pressing);
  return sum > tolerance_ * of_all_[body].pressing;
}

std::vector<int> SleeperLoads::pressed(const BodySet& set, const ContactSet& contacts, const std::vector<char>& asleep,
                                       const std::function<Vec3(int)>& force) {
  const auto touch = [&](int body) {
    if (is_touched_[body]) return;
    is_touched_[body] = 1;
    touched_.push_back(body);
    now_[body] = {};
  };
  touched_.clear();
  for (int i = 0; i < static_cast<int>(contacts.points.size()); ++i) {
    const ContactPoint& point = contacts.points[i];
    if (!asleep[point.bodies[0]] && !asleep[point.bodies[1]]) continue;
    const Vec3 on_first = force(i);
    for (const int side : {0, 1}) {
      const int body = point.bodies[side];
      if (!asleep[body]) continue;
      touch(body);
      add(now_[body], set, body, point.position, side == 0 ? on_first : Vec3(-on_first));
    }
  }
  for (const int body : lean_on_awake_)
    if (asleep[body]) touch(body);
  std::vector<int> pressed;
  for (const int body : touched_) {
    is_touched_[body] = 0;
    if (differ(body, now_[body], of_awake_[body])) pressed.push_back(body);
  }
  return pressed;
}

}  // namespace talus
