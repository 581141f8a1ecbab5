#include "solve/dynamics/acceleration_reset.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "bodies/nodal_motion.hpp"
#include "effects/rigid_inertia.hpp"

namespace talus {

void AccelerationReset::AccelerationChange::add(const Vec3& v0, const Vec3& a0, const Vec3& a1, const Mat3& weight) {
  before += a0.dot(weight * a0);
  after += a1.dot(weight * a1);
  returned += a1.dot(weight * (a0 - a1));
  change += (a0 - a1).dot(weight * (a0 - a1));
  motion += v0.dot(weight * v0);
  along += v0.dot(weight * a1);
}

namespace {

using AccelerationChange = AccelerationReset::AccelerationChange;

AccelerationChange change_over_step(const BodySet& set, const Body& body, const StepContext& step, const Increment& d) {
  AccelerationChange sum;
  const auto add_node = [&](int n) {
    sum.add(set.nodes.velocity[n], start_acceleration(set, step, n), end_acceleration(set, step, n, d));
  };
  if (body.rigid >= 0) {
    const RigidBody& rigid = set.rigid[body.rigid];
    add_node(rigid.centre);
    sum.add(rigid.angular_momentum, rigid.moment, end_moment(set, rigid, step, d),
            rigid.inertia_now().inverse() / rigid.mass);
  } else {
    for (int n = 0; n < body.free_count(); ++n) add_node(body.first_free() + n);
  }
  return sum;
}

/// The accelerations at the start of the step become those at its end.
void set_to_end(BodySet& set, const Body& body, const StepContext& step, const Increment& d) {
  for (int n = body.first_free(); n < body.first_free() + body.free_count(); ++n)
    set.nodes.acceleration[n] = end_acceleration(set, step, n, d);
}

void set_to_zero(BodySet& set, const Body& body) {
  if (body.rigid >= 0) {
    RigidBody& rigid = set.rigid[body.rigid];
    set.nodes.acceleration[rigid.centre] = rigid.moment = Vec3::Zero();
    return;
  }
  std::fill_n(set.nodes.acceleration.begin() + body.first_free(), body.free_count(), Vec3(Vec3::Zero()));
}

}  // namespace

void AccelerationReset::begin_stage(BodySet& set) {
  for (Body& body : set.bodies) body.constant_acceleration = false;
  was_hit_.assign(was_hit_.size(), false);
  goes_on_ = was_hit_;
}

void AccelerationReset::begin_step(BodySet& set) {
  for (const int b : set.moving) {
    set.bodies[b].constant_acceleration = goes_on_[b];
    was_changed_[b] = false;
  }
}

void AccelerationReset::find_blows(const BodySet& set, const StepContext& step, const Increment& d) {
  for (const int b : set.moving) {
    const double change = (forces_[b] - before_[b]).norm();
    was_hit_[b] = change > tolerances_.sudden_change * std::max(forces_[b].norm(), before_[b].norm());
    goes_on_[b] = was_hit_[b] && set.bodies[b].rigid >= 0 &&
                  is_visible(b, change_over_step(set, set.bodies[b], step, d).after, step);
  }
}

void AccelerationReset::note_contact_forces(const BodySet& set, const ContactSet& contacts,
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
}

void AccelerationReset::drop_after_blows(BodySet& set) const {
  for (const int b : set.moving)
    if (was_hit_[b]) set_to_zero(set, set.bodies[b]);
}

bool AccelerationReset::is_visible(int body, double square, const StepContext& step) const {
  const double least = tolerances_.visible_displacement * sizes_[body] / (step.length * step.length);
  return square > least * least;
}

bool AccelerationReset::is_constant(int body, bool is_constant_now, const AccelerationChange& a,
                                    const StepContext& step) const {
  const AccelerationResetTolerances& t = tolerances_;
  if (was_hit_[body]) {
    const bool turns_back = a.motion + step.length * a.along < 0;  // the rest of the blow would throw it back
    return !turns_back && (is_constant_now || is_visible(body, a.after, step));
  }
  const double square = step.length * step.length, least = t.least_displacement * sizes_[body] / square,
               rounding = least * least;
  const bool has_ended = a.before > rounding && a.after < t.acceleration_left * t.acceleration_left * a.before;
  const bool ends_at_once = a.change > t.sudden_change * t.sudden_change * a.before;
  const bool dies_away = square / 8 * a.returned > t.returned_energy * a.motion;
  return is_constant_now || has_ended || (a.change > rounding && a.returned > 0 && (ends_at_once || dies_away));
}

bool AccelerationReset::correct(BodySet& set, const StepContext& step, const Increment& d) {
  bool any = false;
  for (const int b : set.moving) {
    Body& body = set.bodies[b];
    if (was_changed_[b]) continue;
    const bool constant = is_constant(b, body.constant_acceleration, change_over_step(set, body, step, d), step);
    if (constant == body.constant_acceleration) continue;
    was_changed_[b] = any = true;
    if (body.rigid >= 0)
      body.constant_acceleration = constant;
    else
      set_to_end(set, body, step, d);
  }
  return any;
}

}  // namespace talus
