#include "solve/shocks.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "effects/nodal_motion.hpp"
#include "effects/rigid_inertia.hpp"

namespace talus {

namespace {

/// A push that changes by more than this share of the larger is a blow.
constexpr double sudden = 0.3;
/// An acceleration of which less than this share is left is over. Stiff contacts swing to and fro with a third.
constexpr double gone = 0.25;
/// A push that gives back more than this share of a body's kinetic energy in a step is a blow that dies away.
constexpr double lasting = 1e-3;
/// The same of one that has already begun as it ended: what is left of the blow ends smaller still.
constexpr double lasting_on = 1e-5;
/// Of the mesh size: a body that has been struck goes on without an acceleration where it moves it by less in a step.
constexpr double visible = 1e-4;
/// Of the mesh size: an acceleration that moves a body by less in a step is rounding.
constexpr double least_way = 1e-9;

/// How the acceleration of a body changes over a step, its parts weighed alike but for a common factor.
struct Slackening {
  double before = 0;  ///< a₀·a₀
  double after = 0;   ///< a₁·a₁
  double given = 0;   ///< a₁·(a₀ − a₁), what the step gives back
  double change = 0;  ///< (a₀ − a₁)·(a₀ − a₁)
  double motion = 0;  ///< v₀·v₀
  double along = 0;   ///< v₀·a₁

  void add(const Vec3& v0, const Vec3& a0, const Vec3& a1, const Mat3& weight = Mat3::Identity()) {
    before += a0.dot(weight * a0);
    after += a1.dot(weight * a1);
    given += a1.dot(weight * (a0 - a1));
    change += (a0 - a1).dot(weight * (a0 - a1));
    motion += v0.dot(weight * v0);
    along += v0.dot(weight * a1);
  }
};

Slackening slackening_of(const BodySet& set, const Body& body, const StepContext& step, const Increment& d) {
  Slackening sum;
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

/// Gives a body other accelerations to go on with: `of_node`(node) [m/s²], and `moment` [N m] of a rigid one.
void go_on_with(BodySet& set, const Body& body, const auto& of_node, const auto& moment) {
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

/// The body's accelerations at the start of the step become those at its end.
void begin_as_it_ends(BodySet& set, const Body& body, const StepContext& step, const Increment& d) {
  go_on_with(
      set, body, [&](int n) { return end_acceleration(set, step, n, d); },
      [&](const RigidBody& rigid) { return end_moment(rigid, step, d); });
}

void let_go(BodySet& set, const Body& body) {
  const auto none = [](const auto&) { return Vec3(Vec3::Zero()); };
  go_on_with(set, body, none, none);
}

}  // namespace

void Shocks::look(const BodySet& set, const ContactSet& contacts, const std::vector<ContactOutcome>& outcomes) {
  for (const int b : set.moving) {
    before_[b] = pushes_[b];
    slackened_[b] = false;
    pushes_[b].setZero();
  }
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const ContactPoint& point = contacts.points[i];
    for (const int side : {0, 1})
      if (!set.bodies[point.bodies[side]].fixed)
        pushes_[point.bodies[side]] += (side == 0 ? 1 : -1) * outcomes[i].normal_force * point.normal;
  }
}

void Shocks::forget(BodySet& set) {
  for (const int b : set.moving) {
    const double change = (pushes_[b] - before_[b]).norm();
    struck_[b] = change > sudden * std::max(pushes_[b].norm(), before_[b].norm());
    if (struck_[b]) let_go(set, set.bodies[b]);
  }
}

bool Shocks::lets_go(int body, const BodySet& set, const StepContext& step, const Increment& d) const {
  const Slackening a = slackening_of(set, set.bodies[body], step, d);
  const double square = step.length * step.length, unit = step.mesh_size / square;
  const bool turns_back = a.motion + step.length * a.along < 0;  // by the rest of the blow: that would be thrown back
  if (struck_[body]) return !turns_back && a.after > visible * visible * unit * unit;
  const double least = least_way * least_way * unit * unit;
  const bool over = a.before > least && a.after < gone * gone * a.before;
  const bool at_once = a.change > sudden * sudden * a.before;
  const bool dies_away = square / 8 * a.given > (slackened_[body] ? lasting_on : lasting) * a.motion;
  return over || (a.given > least && (at_once || dies_away));
}

bool Shocks::slacken(BodySet& set, const StepContext& step, const Increment& d) {
  bool any = false;
  for (const int b : set.moving) {
    if (!lets_go(b, set, step, d)) continue;
    begin_as_it_ends(set, set.bodies[b], step, d);
    struck_[b] = false;
    slackened_[b] = true;
    any = true;
  }
  return any;
}

}  // namespace talus
