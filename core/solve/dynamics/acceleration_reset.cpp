#include "solve/dynamics/acceleration_reset.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "bodies/nodal_motion.hpp"
#include "effects/rigid_inertia.hpp"

namespace talus {

namespace {

/// How the acceleration of a body changes over a step: sums over its parts, weighed by mass but for a common factor.
struct AccelerationChange {
  double before = 0;    ///< a₀·a₀
  double after = 0;     ///< a₁·a₁
  double returned = 0;  ///< a₁·(a₀ − a₁), what the step returns to the body
  double change = 0;    ///< (a₀ − a₁)·(a₀ − a₁)
  double motion = 0;    ///< v₀·v₀
  double along = 0;     ///< v₀·a₁

  void add(const Vec3& v0, const Vec3& a0, const Vec3& a1, const Mat3& weight = Mat3::Identity()) {
    before += a0.dot(weight * a0);
    after += a1.dot(weight * a1);
    returned += a1.dot(weight * (a0 - a1));
    change += (a0 - a1).dot(weight * (a0 - a1));
    motion += v0.dot(weight * v0);
    along += v0.dot(weight * a1);
  }
};

AccelerationChange change_over_step(const BodySet& set, const Body& body, const StepContext& step, const Increment& d) {
  AccelerationChange sum;
  const auto add_node = [&](int n) {
    sum.add(set.nodes.velocity[n], start_acceleration(set, step, n), end_acceleration(set, step, n, d));
  };
  if (body.rigid >= 0) {
    const RigidBody& rigid = set.rigid[body.rigid];
    add_node(rigid.centre);
    sum.add(rigid.angular_momentum, rigid.moment, end_moment(rigid, step, d),
            rigid.inertia_now().inverse() / rigid.mass);
  } else {
    for (int n = 0; n < body.free_count(); ++n) add_node(body.first_free() + n);
  }
  return sum;
}

/// Sets the accelerations that a body goes on with: `of_node`(node) [m/s²], and `moment` [N m] of a rigid one.
void set_accelerations(BodySet& set, const Body& body, const auto& of_node, const auto& moment) {
  if (body.rigid >= 0) {
    RigidBody& rigid = set.rigid[body.rigid];
    set.nodes.acceleration[rigid.centre] = of_node(rigid.centre);
    rigid.moment = moment(rigid);
    return;
  }
  for (int i = 0; i < body.free_count(); ++i) {
    const int n = body.first_free() + i;
    set.nodes.acceleration[n] = of_node(n);
  }
}

void set_to_end(BodySet& set, const Body& body, const StepContext& step, const Increment& d) {
  set_accelerations(
      set, body, [&](int n) { return end_acceleration(set, step, n, d); },
      [&](const RigidBody& rigid) { return end_moment(rigid, step, d); });
}

void set_to_zero(BodySet& set, const Body& body) {
  const auto none = [](const auto&) { return Vec3(Vec3::Zero()); };
  set_accelerations(set, body, none, none);
}

}  // namespace

void AccelerationReset::note_contact_forces(const BodySet& set, const ContactSet& contacts,
                                            const std::vector<ContactOutcome>& outcomes) {
  for (const int b : set.moving) {
    before_[b] = forces_[b];
    was_reset_[b] = false;
    forces_[b].setZero();
  }
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const ContactPoint& point = contacts.points[i];
    for (const int side : {0, 1})
      if (!set.bodies[point.bodies[side]].fixed)
        forces_[point.bodies[side]] += (side == 0 ? 1 : -1) * outcomes[i].normal_force * point.normal;
  }
}

void AccelerationReset::drop_after_blows(BodySet& set) {
  for (const int b : set.moving) {
    const double change = (forces_[b] - before_[b]).norm();
    was_hit_[b] = change > tolerances_.sudden_change * std::max(forces_[b].norm(), before_[b].norm());
    if (was_hit_[b]) set_to_zero(set, set.bodies[b]);
  }
}

bool AccelerationReset::needs_reset(int body, const BodySet& set, const StepContext& step, const Increment& d) const {
  const AccelerationChange a = change_over_step(set, set.bodies[body], step, d);
  const double square = step.length * step.length, unit = step.mesh_size / square;
  const AccelerationResetTolerances& t = tolerances_;
  if (was_hit_[body]) {
    const bool turns_back = a.motion + step.length * a.along < 0;  // the rest of the blow would throw it back
    return !turns_back && a.after > t.visible_displacement * t.visible_displacement * unit * unit;
  }
  const double rounding = t.least_displacement * t.least_displacement * unit * unit;
  const bool has_ended = a.before > rounding && a.after < t.acceleration_left * t.acceleration_left * a.before;
  const bool ends_at_once = a.change > t.sudden_change * t.sudden_change * a.before;
  const double lasting = was_reset_[body] ? t.returned_energy_after_reset : t.returned_energy;
  const bool dies_away = square / 8 * a.returned > lasting * a.motion;
  return has_ended || (a.returned > rounding && (ends_at_once || dies_away));
}

bool AccelerationReset::reset_to_end(BodySet& set, const StepContext& step, const Increment& d) {
  bool any = false;
  for (const int b : set.moving) {
    if (!needs_reset(b, set, step, d)) continue;
    set_to_end(set, set.bodies[b], step, d);
    was_hit_[b] = false;
    was_reset_[b] = true;
    any = true;
  }
  return any;
}

}  // namespace talus
