#include "solve/dynamics/sleeper_loads.hpp"

#include <Eigen/Geometry>

namespace talus {

void SleeperLoads::add(Load& load, const BodySet& set, int body, const Vec3& at, const Vec3& force) {
  load.force += force;
  load.moment += (at - set.nodes.position[set.bodies[body].first_node]).cross(force);
}

void SleeperLoads::fall_asleep(std::span<const int> sleepers, const BodySet& set, const ContactSet& contacts,
                               std::span<const ContactOutcome> outcomes) {
  std::vector<char> falls_asleep(sizes_.size(), 0);
  for (const int b : sleepers) {
    falls_asleep[b] = 1;
    of_all_[b] = {};
    borne_[b] = 0;
  }
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const ContactPoint& point = contacts.points[i];
    const Vec3 force = outcomes[i].normal_force * point.normal + outcomes[i].shear_force;
    for (const int side : {0, 1}) {
      const int body = point.bodies[side];
      if (!falls_asleep[body]) continue;
      add(of_all_[body], set, body, point.position, side == 0 ? force : Vec3(-force));
      borne_[body] += force.norm();
    }
  }
}

void SleeperLoads::set_resting(const BodySet& set, const std::vector<RestingContact>& resting) {
  of_awake_ = of_all_;
  for (const RestingContact& contact : resting) {
    const Vec3 force = contact.normal_force * contact.normal + contact.shear_force;
    for (const int side : {0, 1}) {
      const int body = contact.bodies[side];
      if (!set.bodies[body].built_fixed())
        add(of_awake_[body], set, body, contact.position, side == 0 ? Vec3(-force) : force);
    }
  }
  lean_on_awake_.clear();
  for (int b = 0; b < static_cast<int>(sizes_.size()); ++b)
    if (differ(b, of_awake_[b], {})) lean_on_awake_.push_back(b);
}

bool SleeperLoads::differ(int body, const Load& a, const Load& b) const {
  const double by_force = (a.force - b.force).norm(), by_moment = (a.moment - b.moment).norm();
  return by_force + by_moment / sizes_[body] > tolerance_ * borne_[body];
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
