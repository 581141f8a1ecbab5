#include "solve/dynamics/free_flight.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "bodies/consistent_mass.hpp"
#include "effects/inertia.hpp"

namespace talus {

namespace {

/// Of what turns round from step to step in a body that flies alone, so much is left: as much as Newmark's method with
/// β = 9/16 leaves of what is too fast for the step.
constexpr double ringing_left = 1.0 / 3;

}  // namespace

FreeFlight::RigidMotion::RigidMotion(const Sums& sums, const Vec3& about)
    : centroid(about + sums.first / sums.mass), velocity(sums.linear / sums.mass) {
  const Mat3 spread = sums.second - sums.first * sums.first.transpose() / sums.mass;
  inertia = spread.trace() * Mat3::Identity() - spread;
  angular = sums.angular - sums.first.cross(velocity);
  turn = inertia.ldlt().solve(angular);
  kinetic = 0.5 * (sums.linear.dot(velocity) + angular.dot(turn));
}

bool FreeFlight::is_possible(const Composition& composition) {
  return std::ranges::none_of(composition.effects, [](const auto& effect) {
    return effect->account() == EnergyAccount::constraint || effect->account() == EnergyAccount::damping ||
           effect->kind() == EffectKind::point_load;
  });
}

void FreeFlight::note_start(const ContactSet& contacts, const std::vector<ContactOutcome>& outcomes) {
  find_groups(contacts, outcomes);
  beside_.resize(set_.nodes.velocity.size());
  for (Group& group : groups_) {
    group.at_start = sums(bodies_of(group), group.about);
    if (!deforms_alone(group)) continue;
    const RigidMotion motion(group.at_start, group.about);
    const Body& body = set_.bodies[bodies_[group.begin]];
    for (int n = body.first_free(); n < body.first_free() + body.free_count(); ++n) beside_[n] = beside(motion, n);
  }
}

void FreeFlight::find_groups(const ContactSet& contacts, const std::vector<ContactOutcome>& outcomes) {
  const int count = static_cast<int>(set_.bodies.size());
  together_.reset(count);
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    if (outcomes[i].normal_force != 0 || !outcomes[i].shear_force.isZero(0))
      together_.join(contacts.points[i].bodies[0], contacts.points[i].bodies[1]);
  is_held_.assign(count, false);
  for (int b = 0; b < count; ++b)
    if (set_.bodies[b].fixed) is_held_[together_.first_of(b)] = true;
  flies_.assign(count, false);
  bodies_.clear();
  for (const int b : set_.moving)
    if (!is_held_[together_.first_of(b)]) bodies_.push_back(b);
  std::ranges::stable_sort(bodies_, {}, [&](int b) { return together_.first_of(b); });
  groups_.clear();
  for (int i = 0; i < static_cast<int>(bodies_.size()); ++i) {
    if (i == 0 || together_.first_of(bodies_[i]) != together_.first_of(bodies_[i - 1]))
      groups_.push_back({i, i, set_.nodes.position[set_.bodies[bodies_[i]].first_node], {}});
    groups_.back().end = i + 1;
  }
  for (const Group& group : groups_)
    if (is_alone(group)) flies_[bodies_[group.begin]] = true;
}

bool FreeFlight::deforms_alone(const Group& group) const {
  return is_alone(group) && set_.bodies[bodies_[group.begin]].kind != BodyKind::rigid;
}

void FreeFlight::end_step(IntegrationReserve& reserve) {
  if (groups_.empty()) return;
  for (const Group& group : groups_) {
    reserve.release(bodies_of(group), keep_angular_momentum(group));
    if (deforms_alone(group)) calm(group);
  }
  set_.carry_velocities();
}

double FreeFlight::keep_angular_momentum(const Group& group) {
  const Sums now = sums(bodies_of(group), group.about), &before = group.at_start;
  const RigidMotion motion(now, group.about);
  const Vec3 by_weight = 0.5 * (before.first + now.first).cross(now.linear - before.linear) / now.mass;
  const Vec3 missed = before.angular + by_weight - now.angular;
  const Vec3 further = motion.inertia.ldlt().solve(missed);
  const double made = further.dot(motion.angular + 0.5 * missed);
  const double beside = Inertia::kinetic_energy(set_, bodies_of(group)) - motion.kinetic;
  const double left = std::max(0.0, beside - std::max(0.0, made));
  set_velocities(group, motion, further, beside > 0 ? std::sqrt(left / beside) : 1);
  return made + left - beside;
}

void FreeFlight::calm(const Group& group) {
  const RigidMotion motion(sums(bodies_of(group), group.about), group.about);
  const Body& body = set_.bodies[bodies_[group.begin]];
  double product = 0, before = 0, now = 0;
  for (int e = body.first_element; e < body.first_element + body.element_count; ++e) {
    const Element& element = set_.elements[e];
    Corners was, is;
    for (int i = 0; i < 4; ++i) {
      was[i] = beside_[element.nodes[i]];
      is[i] = beside(motion, element.nodes[i]);
    }
    product += mass_product(element.mass, was, is);
    before += mass_square(element.mass, was);
    now += mass_square(element.mass, is);
  }
  if (!(product < 0)) return;
  const double to_and_fro = -product / std::sqrt(before * now);  // 1: all of it turns round from step to step
  set_velocities(group, motion, Vec3::Zero(), 1 - (1 - ringing_left) * to_and_fro);
}

void FreeFlight::set_velocities(const Group& group, const RigidMotion& motion, const Vec3& further, double share) {
  const auto set = [&](int n) {
    set_.nodes.velocity[n] = motion.at(set_.nodes.position[n]) +
                             further.cross(set_.nodes.position[n] - motion.centroid) + share * beside(motion, n);
  };
  for (const int b : bodies_of(group)) {
    const Body& body = set_.bodies[b];
    if (body.kind != BodyKind::rigid) {
      for (int n = body.first_free(); n < body.first_free() + body.free_count(); ++n) set(n);
      continue;
    }
    RigidBody& rigid = set_.rigid[body.rigid];
    const Mat3 inertia = rigid.inertia_now();
    const Vec3 common = inertia * motion.turn;
    set(rigid.centre);
    rigid.angular_momentum = common + inertia * further + share * (rigid.angular_momentum - common);
  }
}

FreeFlight::Sums FreeFlight::sums(std::span<const int> bodies, const Vec3& about) const {
  Sums sums;
  for (const int b : bodies) {
    const Body& body = set_.bodies[b];
    if (body.kind == BodyKind::rigid) add(set_.rigid[body.rigid], about, sums);
    for (int e = body.first_element; e < body.first_element + body.element_count; ++e)
      add(set_.elements[e], about, sums);
  }
  return sums;
}

void FreeFlight::add(const RigidBody& body, const Vec3& about, Sums& sums) const {
  const Vec3 arm = set_.nodes.position[body.centre] - about, momentum = body.mass * set_.nodes.velocity[body.centre];
  const Mat3 inertia = body.inertia_now();
  sums.mass += body.mass;
  sums.first += body.mass * arm;
  sums.linear += momentum;
  sums.angular += arm.cross(momentum) + body.angular_momentum;
  sums.second += body.mass * arm * arm.transpose() + 0.5 * inertia.trace() * Mat3::Identity() - inertia;
}

void FreeFlight::add(const Element& element, const Vec3& about, Sums& sums) const {
  const double share = element.mass / 20;  // of the consistent mass, m/20 (1 + δ_ab)
  Vec3 arms = Vec3::Zero(), velocities = Vec3::Zero();
  for (const int n : element.nodes) {
    const Vec3 arm = set_.nodes.position[n] - about;
    arms += arm;
    velocities += set_.nodes.velocity[n];
    sums.angular += share * arm.cross(set_.nodes.velocity[n]);
    sums.second += share * arm * arm.transpose();
  }
  sums.mass += element.mass;
  sums.first += element.mass / 4 * arms;
  sums.linear += element.mass / 4 * velocities;
  sums.angular += share * arms.cross(velocities);
  sums.second += share * arms * arms.transpose();
}

}  // namespace talus
