#include "solve/dynamics/sleeper_loads.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace talus {

void SleeperLoads::add(std::vector<Load>& loads, const BodySet& set, const auto& contact, const Vec3& force,
                       const auto& wanted) {
  for (const int side : {0, 1}) {
    const int body = contact.bodies[side];
    if (!wanted(body)) continue;
    const Vec3 on_body = side == 0 ? force : Vec3(-force);
    loads[body].force += on_body;
    loads[body].moment += (contact.position - set.nodes.position[set.bodies[body].first_node]).cross(on_body);
    loads[body].pressing += on_body.norm();
  }
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
    add(of_all_, set, point, force, [&](int body) { return falls_asleep[body] != 0; });
  }
}

void SleeperLoads::set_resting(const BodySet& set, const std::vector<RestingContact>& resting) {
  now_.assign(now_.size(), {});
  for (const RestingContact& contact : resting) {
    const Vec3 force = contact.normal_force * contact.normal + contact.shear_force;
    add(now_, set, contact, force, [](int) { return true; });
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
  // Whether it sleeps; then it is touched.
  const auto touch = [&](int body) {
    if (asleep[body] && !is_touched_[body]) {
      is_touched_[body] = 1;
      touched_.push_back(body);
      now_[body] = {};
    }
    return asleep[body] != 0;
  };
  touched_.clear();
  for (int i = 0; i < static_cast<int>(contacts.points.size()); ++i) {
    const ContactPoint& point = contacts.points[i];
    if (!asleep[point.bodies[0]] && !asleep[point.bodies[1]]) continue;
    add(now_, set, point, force(i), touch);
  }
  for (const int body : lean_on_awake_) touch(body);
  std::vector<int> pressed;
  for (const int body : touched_) {
    is_touched_[body] = 0;
    if (differ(body, now_[body], of_awake_[body])) pressed.push_back(body);
  }
  return pressed;
}

}  // namespace talus
