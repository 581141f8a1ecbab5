#include "solve/dynamics/impacts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <tuple>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "contact/contact_law.hpp"
#include "effects/inertia.hpp"

namespace talus {

namespace {

constexpr int hits_worth_a_thread = 100;

/// At which the bodies part [m/s].
double speed_of(const BodySet& set, const ContactSet& contacts, const ContactPoint& point, double step) {
  const auto [nodes, weights] = contacts.stencil(point);
  return point.normal.dot(velocity_of(set, nodes, weights, step));
}

/// The largest mobility in a direction across the normal [1/kg].
double mobility_across(const Mat3& mobility, const Vec3& normal) {
  const Vec3 e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  const double a = e1.dot(mobility * e1), b = e1.dot(mobility * e2), c = e2.dot(mobility * e2);
  return 0.5 * (a + c) + std::hypot(0.5 * (a - c), b);
}

double spring_energy_at_start(const ContactPoint& point) {
  return normal_spring_energy(point, normal_force(point, point.gap)) + shear_spring_energy(point, point.shear_start);
}

double mass_of(const Body& body) { return body.fixed ? 1e300 : body.mass(); }

}  // namespace

void Impacts::note_speeds(const ContactSet& contacts, const StepContext& step) {
  const Stopwatch watch(seconds_);
  if (!contacts.loose.empty()) energy_.note_start();
  closing_.clear();
  for (const int i : contacts.loose) closing_.push_back(-speed_of(set_, contacts, contacts.points[i], step.length));
}

Impacts::Range Impacts::range(const ContactPoint& point, double restitution, double closing, double speed,
                              const ContactOutcome& end, double step) const {
  const double leaves = restitution * std::max(0.0, closing);
  const bool has_met = point.gap > tolerances_.landing_gap * point.size;  // in this step
  const double pushed_out = point.let_go ? 0 : -end.gap / (tolerances_.steps_to_part * step);
  return {has_met ? leaves : std::min(0.0, speed), std::max(leaves, pushed_out)};
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
  const double followed = tolerances_.followed_oscillation;
  const auto swings_slowly = [&](int b) {
    return springs_[b] * step * step < followed * followed * mass_of(set_.bodies[b]);
  };
  const auto& [a, b] = point.bodies;
  return swings_slowly(a) && swings_slowly(b);
}

double Impacts::let_go_landed(ContactSet& contacts, const StepContext& step,
                              const std::vector<ContactOutcome>& outcomes) {
  const Stopwatch watch(seconds_);
  add_up_springs(contacts, outcomes);
  double energy = 0;
  for (const int i : contacts.loose) {
    ContactPoint& point = contacts.points[i];
    const double force = outcomes[i].normal_force;
    const bool landed = force > 0 && point.gap > tolerances_.landing_gap * point.size;
    if (!landed || left_to_springs(point, step.length)) continue;
    point.let_go = true;
    energy += force * force / (2 * point.normal_stiffness);
  }
  return energy;
}

void Impacts::gather(const ContactSet& contacts, double step, const std::vector<ContactOutcome>& outcomes) {
  struck_.clear();
  groups_.reset(static_cast<int>(set_.bodies.size()));
  add_up_springs(contacts, outcomes);
  for (std::size_t k = 0; k < contacts.loose.size(); ++k) {
    const int i = contacts.loose[k];
    const ContactPoint& point = contacts.points[i];
    if (!(outcomes[i].normal_force > 0) || left_to_springs(point, step)) continue;
    const double speed = speed_of(set_, contacts, point, step);
    if (point.restitution) ++restitutions_;
    const auto& [a, b] = point.bodies;
    if (!set_.bodies[a].fixed && !set_.bodies[b].fixed) groups_.join(a, b);
    const double restitution = point.restitution.value_or(0);
    const Range speeds = range(point, restitution, closing_[k], speed, outcomes[i], step);
    const Range inelastic = range(point, 0, closing_[k], speed, outcomes[i], step);
    const double lighter = std::min(mass_of(set_.bodies[a]), mass_of(set_.bodies[b]));
    const double rounding = tolerances_.negligible_speed * outcomes[i].normal_force * step / lighter;
    const bool throws_back = speeds.highest > inelastic.highest;  // whether that makes energy is to be seen
    const bool as_it_should = !throws_back && speed > speeds.lowest - rounding && speed < speeds.highest + rounding;
    struck_.push_back({i, speeds, inelastic, as_it_should, set_.bodies[a].fixed ? b : a});
  }
  is_wrong_.assign(set_.bodies.size(), false);
  for (Struck& struck : struck_) {
    struck.group = groups_.first_of(struck.group);
    if (!struck.parts_as_it_should) is_wrong_[struck.group] = true;
  }
  std::erase_if(struck_, [&](const Struck& struck) { return !is_wrong_[struck.group]; });
  std::ranges::stable_sort(struck_, {}, &Struck::group);
  find_layers(contacts);
}

template <class Use>
void Impacts::each_group(const Use& use) {
  for (std::size_t begin = 0, end = 0; begin < struck_.size(); begin = end) {
    while (end < struck_.size() && struck_[end].group == struck_[begin].group) ++end;
    use(begin, end - begin);
  }
}

void Impacts::find_layers(const ContactSet& contacts) {
  const auto moved = [&](int body) { return set_.bodies[body].fixed ? -1 : body; };
  each_group([&](std::size_t begin, std::size_t count) {
    const auto group = std::span(struck_).subspan(begin, count);
    pairs_.clear();
    for (const Struck& struck : group) {
      const auto& [a, b] = contacts.points[struck.point].bodies;
      pairs_.push_back({moved(a), moved(b)});
    }
    const std::vector<int>& layers = sweep_layers_.of(pairs_, static_cast<int>(set_.bodies.size()));
    for (std::size_t i = 0; i < count; ++i) group[i].layer = layers[i];
    std::ranges::stable_sort(group, {}, &Struck::layer);
  });
}

void Impacts::list_layers(std::span<const Struck> group) {
  layer_begins_.assign(1, 0);
  for (std::size_t i = 1; i < group.size(); ++i)
    if (group[i].layer != group[i - 1].layer) layer_begins_.push_back(static_cast<int>(i));
  layer_begins_.push_back(static_cast<int>(group.size()));
}

double Impacts::Hit::strike(BodySet& set, double push_more, const Vec3& shear_more) {
  const Vec3 change = push_more * normal + shear_more;
  pushed += push_more;
  sheared += shear_more;
  where.strike(set, change);
  return change.norm();
}

double Impacts::update(Hit& hit) {
  const Vec3 v = hit.where.velocity(set_);
  const double speed = hit.normal.dot(v);
  const double without = speed - hit.along * hit.pushed;
  const double wanted = std::clamp(without, hit.range.lowest, hit.range.highest);
  const double pushed = std::max(-hit.push, (wanted - without) / hit.along);

  const Vec3 sideways = v - speed * hit.normal;
  Vec3 shear = hit.shear + hit.sheared - sideways / hit.sideways;
  shear -= hit.normal * hit.normal.dot(shear);
  const double strength = hit.friction * (hit.push + pushed), length = shear.norm();
  if (length > strength) shear *= strength / length;

  return hit.strike(set_, pushed - hit.pushed, shear - hit.shear - hit.sheared);
}

void Impacts::find_impulses(std::span<Hit> hits) {
  double largest_push = 0;
  for (const Hit& hit : hits) largest_push = std::max(largest_push, hit.push);
  double change = largest_push;
  for (int sweep = 0; change > tolerances_.impulse_accuracy * largest_push; ++sweep) {
    if (sweep == tolerances_.sweep_limit) {
      ++sweep_limits_;
      return;
    }
    change = sweep_over(hits);
  }
}

double Impacts::sweep_over(std::span<Hit> hits) {
  const int layers = static_cast<int>(layer_begins_.size()) - 1;
  changes_.resize(layers);
  for (const int parity : {0, 1}) {
    const auto sweep_some = [&](int first, int last) {
      for (int layer = 2 * first + parity; layer < 2 * last + parity; layer += 2) {
        double change = 0;  // of its own, for others write beside it in the list
        for (Hit& hit : hits.subspan(layer_begins_[layer], layer_begins_[layer + 1] - layer_begins_[layer]))
          change = std::max(change, update(hit));
        changes_[layer] = change;
      }
    };
    in_parallel((layers + 1 - parity) / 2, 1, std::ref(sweep_some));
  }
  return *std::ranges::max_element(changes_);
}

void Impacts::take_away(std::span<Hit> hits) {
  for (Hit& hit : hits) hit.strike(set_, -(hit.push + hit.pushed), -(hit.shear + hit.sheared));
}

std::vector<int> Impacts::bodies_of(std::span<const Hit> hits) const {
  std::vector<int> bodies;
  for (const Hit& hit : hits) bodies.insert(bodies.end(), hit.bodies.begin(), hit.bodies.end());
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return bodies;
}

double Impacts::by_driven(std::span<const Hit> hits) {
  double sum = 0;
  for (const Hit& hit : hits)
    sum -= hit.where.driven().dot((hit.push + hit.pushed) * hit.normal + hit.shear + hit.sheared);
  return sum;
}

void Impacts::limit_energy(std::span<Hit> hits, std::span<const int> bodies, double step) {
  double to_springs = 0;
  for (const Hit& hit : hits) to_springs += hit.spring_gain;
  const auto make_energy = [&] {
    return energy_.gain() - by_driven(hits) + to_springs > tolerances_.negligible_energy * energy_.kinetic();
  };
  // The bodies part at this fraction of their restitution; or by this share of the impulses.
  const auto makes_some_at = [&](double fraction) {
    take_away(hits);
    for (Hit& hit : hits) hit.range = hit.inelastic.towards(hit.elastic, fraction);
    find_impulses(hits);
    return make_energy();
  };
  const auto makes_some_by = [&](double share) {
    for (Hit& hit : hits) hit.strike(set_, share * hit.found_push - hit.pushed, share * hit.found_shear - hit.sheared);
    return make_energy();
  };
  const auto note_found = [&] {
    for (Hit& hit : hits) std::tie(hit.found_push, hit.found_shear) = std::tie(hit.pushed, hit.sheared);
  };
  const auto limit = [&](const auto& makes_some) {
    double least = 0, most = 1;
    while (most - least > tolerances_.negligible_energy) {
      const double middle = (least + most) / 2;
      (makes_some(middle) ? most : least) = middle;
    }
    makes_some(least);
  };

  note_found();
  take_away(hits);
  energy_.note_without_contact(bodies, step);
  if (!makes_some_by(1)) return;
  if (!makes_some_at(0)) return limit(makes_some_at);
  note_found();
  if (!makes_some_by(0)) return limit(makes_some_by);
  makes_some_by(1);  // that springs make it is not theirs to mend
}

Impacts::Hit Impacts::hit_of(const Struck& struck, const ContactSet& contacts, double step,
                             const ContactOutcome& outcome) {
  const ContactPoint& point = contacts.points[struck.point];
  const auto [nodes, weights] = contacts.stencil(point);
  Hit hit{.where = {set_, masses_, nodes, weights, step},
          .normal = point.normal,
          .range = struck.range,
          .elastic = struck.range,
          .inelastic = struck.inelastic,
          .bodies = {point.bodies[0], point.bodies[1]},
          .spring_gain = spring_energy(point, outcome) - spring_energy_at_start(point),
          .friction = point.friction,
          .push = outcome.normal_force * step,
          .shear = outcome.shear_force * step};
  const Mat3& mobility = hit.where.mobility();
  hit.along = point.normal.dot(mobility * point.normal);
  hit.sideways = mobility_across(mobility, point.normal);
  return hit;
}

void Impacts::find_hits(const ContactSet& contacts, double step, const std::vector<ContactOutcome>& outcomes) {
  for (const Struck& struck : struck_)
    for (const int body : contacts.points[struck.point].bodies)
      if (!set_.bodies[body].fixed && set_.bodies[body].kind != BodyKind::rigid) masses_.make(body);
  hits_.clear();
  hits_.resize(struck_.size());
  const auto find_some = [&](int first, int last) {
    for (int i = first; i < last; ++i) hits_[i] = hit_of(struck_[i], contacts, step, outcomes[struck_[i].point]);
  };
  in_parallel(static_cast<int>(struck_.size()), hits_worth_a_thread, std::ref(find_some));
}

ImpactEnergy Impacts::apply(const ContactSet& contacts, const StepContext& step,
                            const std::vector<ContactOutcome>& outcomes, IntegrationReserve& reserve) {
  const Stopwatch watch(seconds_);
  ++evaluations_;
  gather(contacts, step.length, outcomes);
  if (struck_.empty()) return {};
  find_hits(contacts, step.length, outcomes);
  ImpactEnergy energy;
  each_group([&](std::size_t begin, std::size_t count) {
    const auto hits = std::span(hits_).subspan(begin, count);
    list_layers(std::span(struck_).subspan(begin, count));
    const std::vector<int> bodies = bodies_of(hits);
    const double before = Inertia::kinetic_energy(set_, bodies);
    const double by_springs = by_driven(hits);
    find_impulses(hits);
    const auto given = [&] { return Inertia::kinetic_energy(set_, bodies) - before - (by_driven(hits) - by_springs); };
    if (given() > 0 || std::ranges::any_of(hits, &Hit::throws_back)) limit_energy(hits, bodies, step.length);
    reserve.release(bodies, given());
    energy.taken -= given();
    energy.by_driven += by_driven(hits) - by_springs;
  });
  set_.carry_velocities();
  return energy;
}

}  // namespace talus
