#include "solve/impacts.hpp"

#include <algorithm>
#include <span>

#include "effects/inertia.hpp"
#include "solve/stopwatch.hpp"

namespace talus {

namespace {

/// Springs may push out what penetrates in this many steps, but no faster.
constexpr double steps_to_part = 10;
/// A body swings on springs of stiffness K by ω = √(K/m). Up to this ωΔ it is thrown back at about the same speed
/// wherever in the step it lands, within 0.07 of that of landing; at three it is 0.13 to 0.48 of it, at ten 0 to 0.7.
constexpr double followed = 2;
/// Of what the contact's push alone does to its speed in a step: less is left alone, …
constexpr double negligible = 1e-9;
/// … and this is how well the impulses are found, in so many sweeps at most.
constexpr double exactness = 1e-9;
constexpr int sweep_limit = 500;

struct Stencil {
  std::span<const int> nodes;
  std::span<const double> weights;
};

Stencil stencil(const ContactSet& contacts, const ContactPoint& point) {
  const auto count = static_cast<std::size_t>(point.stencil_end - point.stencil_begin);
  return {std::span(contacts.nodes).subspan(point.stencil_begin, count),
          std::span(contacts.weights).subspan(point.stencil_begin, count)};
}

/// At which the bodies part [m/s].
double speed_of(const BodySet& set, const ContactSet& contacts, const ContactPoint& point, double step) {
  const auto [nodes, weights] = stencil(contacts, point);
  return point.normal.dot(velocity_of(set, nodes, weights, step));
}

double mass_of(const Body& body) { return body.fixed ? 1e300 : body.density * body.reference_volume; }

}  // namespace

void Impacts::note_speeds(const ContactSet& contacts, const StepContext& step) {
  const Stopwatch watch(seconds_);
  closing_.clear();
  for (const int i : contacts.loose) closing_.push_back(-speed_of(set_, contacts, contacts.points[i], step.length));
}

Impacts::Range Impacts::range(const ContactPoint& point, double closing, double speed, const ContactOutcome& end,
                              double step) const {
  const double leaves = point.restitution.value_or(0) * std::max(0.0, closing);
  const bool has_met = point.gap > 0;  // in this step
  return {has_met ? leaves : std::min(0.0, speed), std::max(leaves, -end.gap / (steps_to_part * step))};
}

void Impacts::add_up_springs(const ContactSet& contacts, const std::vector<ContactOutcome>& outcomes) {
  springs_.assign(set_.bodies.size(), 0);
  for (const int i : contacts.loose) {
    if (!(outcomes[i].normal_force > 0)) continue;
    const ContactPoint& point = contacts.points[i];
    for (const int body : point.bodies) springs_[body] += point.normal_stiffness;
  }
}

bool Impacts::left_to_springs(const ContactPoint& point, double step) const {
  if (point.restitution) return false;
  const auto deforms = [&](int b) { return !set_.bodies[b].fixed && set_.bodies[b].kind != BodyKind::rigid; };
  const auto swings_slowly = [&](int b) {
    return springs_[b] * step * step < followed * followed * mass_of(set_.bodies[b]);
  };
  const auto& [a, b] = point.bodies;
  return deforms(a) || deforms(b) || (swings_slowly(a) && swings_slowly(b));
}

bool Impacts::gather(const ContactSet& contacts, double step, const std::vector<ContactOutcome>& outcomes) {
  struck_.clear();
  bool as_it_should = true;
  add_up_springs(contacts, outcomes);
  for (std::size_t k = 0; k < contacts.loose.size(); ++k) {
    const int i = contacts.loose[k];
    const ContactPoint& point = contacts.points[i];
    if (!(outcomes[i].normal_force > 0) || left_to_springs(point, step)) continue;
    const double speed = speed_of(set_, contacts, point, step);
    struck_.push_back({i, range(point, closing_[k], speed, outcomes[i], step)});
    const auto& [lowest, highest] = struck_.back().range;
    const double lighter = std::min(mass_of(set_.bodies[point.bodies[0]]), mass_of(set_.bodies[point.bodies[1]]));
    const double noise = negligible * outcomes[i].normal_force * step / lighter;
    as_it_should = as_it_should && speed > lowest - noise && speed < highest + noise;
  }
  return !as_it_should;
}

/// Finds the impulse of one contact while the others stay; returns by how much it has changed [N s].
double Impacts::relax(Hit& hit) {
  const Vec3 v = hit.where.velocity(set_);
  const double speed = hit.normal.dot(v), mobility = hit.normal.dot(hit.where.mobility() * hit.normal);
  const double without = speed - mobility * hit.pushed;
  const double wanted = std::clamp(without, hit.range.lowest, hit.range.highest);
  const double pushed = std::max(-hit.push, (wanted - without) / mobility);

  const Vec3 sideways = v - speed * hit.normal;
  const double sluggish = hit.where.mobility().trace();  // no less than the mobility in any direction
  Vec3 shear = hit.shear + hit.sheared - sideways / sluggish;
  shear -= hit.normal * hit.normal.dot(shear);
  const double strength = hit.friction * (hit.push + pushed), length = shear.norm();
  if (length > strength) shear *= strength / length;

  const Vec3 change = (pushed - hit.pushed) * hit.normal + (shear - hit.shear - hit.sheared);
  hit.pushed = pushed;
  hit.sheared = shear - hit.shear;
  hit.where.strike(set_, change);
  return change.norm();
}

double Impacts::take(const ContactSet& contacts, const StepContext& step, const std::vector<ContactOutcome>& outcomes) {
  const Stopwatch watch(seconds_);
  ++evaluations_;
  if (!gather(contacts, step.length, outcomes)) return 0;
  hits_.clear();
  double largest = 0;
  for (const auto& [i, range] : struck_) {
    const ContactPoint& point = contacts.points[i];
    const auto [nodes, weights] = stencil(contacts, point);
    hits_.push_back({.where = {set_, masses_, nodes, weights, step.length},
                     .normal = point.normal,
                     .range = range,
                     .friction = point.friction,
                     .push = outcomes[i].normal_force * step.length,
                     .shear = outcomes[i].shear_force * step.length});
    largest = std::max(largest, hits_.back().push);
  }
  const double before = Inertia::kinetic_energy(set_);
  double change = largest;
  for (int sweep = 0; sweep < sweep_limit && change > exactness * largest; ++sweep) {
    change = 0;
    for (Hit& hit : hits_) change = std::max(change, relax(hit));
  }
  set_.carry_velocities();
  return before - Inertia::kinetic_energy(set_);
}

}  // namespace talus
