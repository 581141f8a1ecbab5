#include "solve/dynamics/acceleration_reset.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "contact/contact_law.hpp"

namespace talus {

void AccelerationReset::begin_stage(BodySet& set) {
  for (Body& body : set.bodies) body.constant_acceleration = false;
  was_hit_.assign(was_hit_.size(), false);
  for (std::size_t b = 0; b < set.bodies.size(); ++b) goes_on_[b] = set.bodies[b].rigid >= 0;
  pasts_.assign(pasts_.size(), {});
}

void AccelerationReset::note_touching(const BodySet& set, const ContactSet& contacts,
                                      const std::function<double(int)>& gap, double touching) {
  touches_.assign(set.bodies.size(), false);
  for (int i = 0; i < static_cast<int>(contacts.points.size()); ++i)
    if (touches(contacts.points[i], gap(i), touching))
      for (const int b : contacts.points[i].bodies) touches_[b] = true;
}

void AccelerationReset::let_fly(const BodySet& set, const ContactSet& contacts, double touching) {
  note_touching(
      set, contacts, [&](int i) { return contacts.points[i].gap; }, touching);
  for (const int b : set.moving) goes_on_[b] = goes_on_[b] || !touches_[b];
}

bool AccelerationReset::take_off(BodySet& set, const ContactLinks& links, const Increment& d, double touching) {
  note_touching(
      set, links.contacts(), [&](int i) { return links.gap(i, d); }, touching);
  bool any = false;
  for (const int b : set.moving) {
    Body& body = set.bodies[b];
    if (body.rigid >= 0 || body.constant_acceleration || touches_[b]) continue;
    body.constant_acceleration = any = true;
  }
  return any;
}

void AccelerationReset::begin_step(BodySet& set) const {
  for (const int b : set.moving) set.bodies[b].constant_acceleration = goes_on_[b];
}

void AccelerationReset::note_start(const BodySet& set, const ContactSet& contacts,
                                   const std::vector<ContactOutcome>& outcomes) {
  for (const int b : set.moving) {
    before_[b] = forces_[b];
    forces_[b].setZero();
  }
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const ContactPoint& point = contacts.points[i];
    for (const int side : {0, 1})
      if (!set.bodies[point.bodies[side]].fixed)
        forces_[point.bodies[side]] += (side == 0 ? 1 : -1) * outcomes[i].normal_force * point.normal;
  }
  for (const int b : set.moving) {
    const double change = (forces_[b] - before_[b]).norm();
    was_hit_[b] = change > tolerances_.sudden_change * std::max(forces_[b].norm(), before_[b].norm());
  }
  for (const int r : set.turning) {
    const RigidBody& rigid = set.rigid[r];
    pasts_[set.nodes.body[rigid.centre]].start = {set.nodes.velocity[rigid.centre], rigid.angular_momentum};
  }
}

void AccelerationReset::drop(BodySet& set, const FreeFlight& free_flight) const {
  const auto estimates_errors = [&](int b) { return set.bodies[b].kind != BodyKind::rigid && free_flight.flies(b); };
  for (const int b : set.moving)
    if (was_hit_[b] || (set.bodies[b].constant_acceleration && !estimates_errors(b))) set.scale_acceleration(b, 0);
}

void AccelerationReset::end_step(const BodySet& set, double length, const FreeFlight& free_flight) {
  for (const int r : set.turning) {
    const RigidBody& rigid = set.rigid[r];
    const int b = set.nodes.body[rigid.centre];
    const bool swung = !set.bodies[b].constant_acceleration;
    goes_on_[b] = !swings(rigid, set.nodes.velocity[rigid.centre], length, swung, pasts_[b]) || was_hit_[b];
    if (was_hit_[b]) pasts_[b].change.reset();
  }
  for (const int b : set.moving)
    if (set.bodies[b].rigid < 0) goes_on_[b] = free_flight.flies(b);
}

bool AccelerationReset::swings(const RigidBody& rigid, const Vec3& velocity, double length, bool swung,
                               Past& past) const {
  const Mat3 inverse = rigid.inertia_now().inverse() / rigid.mass;
  const auto product = [&](const Pair& a, const Pair& b) {
    return a.linear.dot(b.linear) + a.angular.dot(inverse * b.angular);
  };
  const Pair now{(velocity - past.start.linear) / length, (rigid.angular_momentum - past.start.angular) / length};
  const std::optional<Pair> last = std::exchange(past.acceleration, now);
  if (!last) return swung;
  const Pair change{now.linear - last->linear, now.angular - last->angular};
  const std::optional<Pair> before = std::exchange(past.change, change);
  const double least = tolerances_.visible_swing * rigid.reach / (length * length);
  const double large = std::max(tolerances_.swing * tolerances_.swing * product(*last, *last), least * least);
  return swung ? product(change, change) > large : before && product(change, *before) < -large;
}

}  // namespace talus
