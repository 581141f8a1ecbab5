#include "solve/dynamics/acceleration_reset.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "bodies/nodal_motion.hpp"
#include "effects/rigid_inertia.hpp"

namespace talus {

void AccelerationReset::begin_stage(BodySet& set) {
  for (Body& body : set.bodies) body.constant_acceleration = false;
  was_hit_.assign(was_hit_.size(), false);
  for (std::size_t b = 0; b < set.bodies.size(); ++b) goes_on_[b] = set.bodies[b].rigid >= 0;
  ends_.assign(ends_.size(), {});
}

void AccelerationReset::begin_step(BodySet& set) const {
  for (const int b : set.moving) set.bodies[b].constant_acceleration = goes_on_[b];
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

void AccelerationReset::look_at(const BodySet& set, const StepContext& step, const Increment& d) {
  for (const int b : set.moving) {
    const double change = (forces_[b] - before_[b]).norm();
    was_hit_[b] = change > tolerances_.sudden_change * std::max(forces_[b].norm(), before_[b].norm());
    if (set.bodies[b].rigid >= 0) goes_on_[b] = goes_on_with_the_end(set, b, step, d);
  }
}

bool AccelerationReset::goes_on_with_the_end(const BodySet& set, int body, const StepContext& step,
                                             const Increment& d) {
  const RigidBody& rigid = set.rigid[set.bodies[body].rigid];
  const End end{end_acceleration(set, step, rigid.centre, d), end_moment(set, rigid, step, d)};
  const Mat3 inverse = rigid.inertia_now().inverse() / rigid.mass;
  const auto product = [&](const End& a, const End& b) {  // m²/s⁴
    return a.acceleration.dot(b.acceleration) + a.moment.dot(inverse * b.moment);
  };
  const std::optional<End> before = std::exchange(ends_[body], end);
  if (was_hit_[body]) {
    const double least = tolerances_.visible_displacement * sizes_[body] / (step.length * step.length);
    return product(end, end) > least * least;
  }
  if (!before) return set.bodies[body].constant_acceleration;
  const End change{before->acceleration - end.acceleration, before->moment - end.moment};
  const bool dies_away = product(end, change) > 0;
  return dies_away ||
         product(change, change) < tolerances_.sudden_change * tolerances_.sudden_change * product(*before, *before);
}

void AccelerationReset::drop(BodySet& set) const {
  for (const int b : set.moving)
    if (was_hit_[b] || set.bodies[b].constant_acceleration) set.scale_acceleration(b, 0);
}

}  // namespace talus
