#include "contact/detection/contact_detector.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "base/parallel.hpp"
#include "base/state_archive.hpp"
#include "contact/body_width.hpp"
#include "contact/broad/broad_phase.hpp"
#include "contact/contact_features.hpp"
#include "contact/contact_law.hpp"
#include "contact/history/contact_memory.hpp"
#include "contact/history/coupling.hpp"
#include "contact/history/spring_handover.hpp"
#include "contact/narrow/point_search.hpp"
#include "contact/narrow/updated_normal.hpp"

namespace talus {
namespace {

constexpr int contacts_worth_a_thread = 256;
constexpr double rounding_of_energy = 1e-9;  // – of it: forces that go on stay what they are to the bit

}  // namespace

struct ContactDetector::State {
  State(std::vector<ContactBody> b, std::vector<JointLaw> l, PairJoints joints, ContactSettings s)
      : bodies(std::move(b)),
        laws(std::move(l)),
        pair_joints(std::move(joints)),
        settings(s),
        features(bodies, s.model == ContactModel::facet_wise),
        broad(features, bodies, settings, work),
        shapes(features, broad.odometers(), settings.tolerances),
        search(settings),
        memory(bodies.size(), s.model == ContactModel::facet_wise, s.tolerances),
        coupling(features),
        asleep(bodies.size(), 0),
        penetration(bodies.size(), 0.0),
        moved(bodies.size(), 0),
        found(s.tolerances.least_stencil_weight),
        ahead(s.tolerances.least_stencil_weight) {}

  bool rests(int body) const { return bodies[body].fixed || asleep[body]; }
  bool joints_bond() const;
  double bond_reach() const;
  void measure_bodies(std::span<const Vec3> x);
  StepGeometry look(std::span<const Vec3> x, const Reach& reach);
  void find_points(std::span<const Vec3> x);
  int given(std::uint64_t key) const;
  double initial_interference(const FoundPoint& found, double normal_stiffness) const;
  void go_on_from(const ContactMemory::TransferredHistory& past, const FoundPoint& found, ContactPoint& point) const;
  ContactPoint complete(int number) const;
  void complete_all();
  void bond(std::span<ContactPoint> points) const;
  void weaken_broken(std::span<ContactPoint> points) const;
  void write(ContactSet& contacts);
  void put_in_order();
  void hand_out(ContactSet& contacts);
  void change_rest(std::span<const int> changed);

  std::vector<ContactBody> bodies;
  std::vector<JointLaw> laws;
  PairJoints pair_joints;
  ContactSettings settings;
  ContactFeatures features;
  ContactWork work;
  BroadPhase broad;
  FeatureShapes shapes;
  PointSearch search;
  ContactMemory memory;
  SpringHandover handover;
  Coupling coupling;
  std::vector<char> asleep;         // a body
  std::vector<double> penetration;  // m, a movable body: the deepest of the last step
  std::vector<double> widths;       // m, a body, as it was seen first
  std::vector<double> first_areas;  // m², a facet, as it was seen first
  std::vector<int> pressed;         // bodies whose penetration the next step may change
  std::vector<char> moved;          // a body: it took part in a step and neither was fixed nor asleep
  bool all_have_moved = false;      // that are free to

  Reach reach, searched;  // that detect() was told; with what bonds need
  FoundPoints found, ahead;
  std::vector<MissedContact> missed;
  std::vector<int> origins;             // of the points handed out: which one of `found` each was made of
  std::vector<std::uint64_t> families;  // of the points handed out
  std::vector<int> given_as;            // of a point of `found`: its number among those handed out, or −1
  std::vector<ContactPoint> by_key;     // points before they are handed out …
  std::vector<int> by_key_origins;      // … with what they were made of
  std::vector<int> order;               // … those that are, in their order
};

ContactDetector::ContactDetector(std::vector<ContactBody> bodies, std::vector<JointLaw> laws, PairJoints pair_joints,
                                 ContactSettings settings)
    : state_(std::make_unique<State>(std::move(bodies), std::move(laws), std::move(pair_joints), settings)) {}

ContactDetector::~ContactDetector() = default;

bool ContactDetector::State::joints_bond() const {
  return std::any_of(laws.begin(), laws.end(),
                     [](const JointLaw& law) { return law.cohesion > 0 || law.tensile_strength > 0; });
}

/// A bond of a soft joint holds over a gap that no step's displacement would reach.
double ContactDetector::State::bond_reach() const {
  double widest = 0;
  for (const JointLaw& law : laws) {
    if (law.normal_stiffness > 0) widest = std::max(widest, law.tensile_strength / law.normal_stiffness);
  }
  return widest;
}

void ContactDetector::State::measure_bodies(std::span<const Vec3> x) {
  for (const ContactBody& body : bodies) widths.push_back(least_width(body, x));
  for (const ContactFacet& facet : features.facets) first_areas.push_back(facet_area(facet, x));
}

/// What the searches look at, at the positions x.
StepGeometry ContactDetector::State::look(std::span<const Vec3> x, const Reach& reach) {
  shapes.look(x);
  return {.features = features,
          .broad = broad,
          .x = x,
          .penetration = penetration,
          .widths = widths,
          .first_areas = first_areas,
          .tolerances = settings.tolerances,
          .reach = reach,
          .moved = moved,
          .memory = memory,
          .shapes = shapes,
          .work = work};
}

void ContactDetector::State::find_points(std::span<const Vec3> x) {
  if (widths.empty()) measure_bodies(x);
  searched = reach;
  searched.least = std::max(reach.least, bond_reach());
  const StepGeometry step = look(x, searched);
  const auto distance = [&](int a, int b) { return search.distance(step, a, b); };
  search.find(step, broad.find(x, searched, std::ref(distance)), found);
}

/// A contact that is found deep was there before and was missed, where one feature takes over from another. It goes on
/// from what another contact did there in the last step, and pushes against what comes on top: pushing back all of it
/// would make energy from nothing.
double ContactDetector::State::initial_interference(const FoundPoint& f, double normal_stiffness) const {
  return f.gap < 0 ? std::max(0.0, -f.gap - memory.known_compression(f, normal_stiffness)) : 0;
}

/// What the point takes over. Another spring might push harder, by the gap, than the force that goes on in it, and a
/// softer one hold more energy; so might the same spring where its features measure the gap anew, as a corner does that
/// slides from one facet on to the next. It is compressed as it was then, and the rest of the gap interferes. Where
/// springs of both bodies only stop them, the law of impact takes what they make, and depth is not to grow.
void ContactDetector::State::go_on_from(const ContactMemory::TransferredHistory& past, const FoundPoint& f,
                                        ContactPoint& p) const {
  p.bonded = past.bonded && f.area > 0;
  p.mode = past.mode;
  p.shear_start = past.shear;
  p.multiplier = past.multiplier;
  p.slip_start = past.slip;
  p.initial_interference = past.initial_interference;
  p.penalty_scaling = past.penalty_scaling;
  p.normal_stiffness *= p.penalty_scaling;
  p.shear_stiffness *= p.penalty_scaling;
  const double compression =
      std::min(past.spring_force / p.normal_stiffness, std::sqrt(2 * past.spring_energy / p.normal_stiffness));
  const bool rebounds = bodies[p.bodies[0]].deforms || bodies[p.bodies[1]].deforms;
  const double change = std::abs(-f.gap - p.initial_interference - compression);
  const bool is_measured_anew =
      settings.model == ContactModel::area && rebounds && change > settings.tolerances.same_compression * compression;
  if (!past.same_spring || is_measured_anew) p.initial_interference = std::max(0.0, -f.gap - compression);
  const double energy = shear_spring_energy(p, p.shear_start);
  if (energy > (1 + rounding_of_energy) * past.shear_energy) p.shear_start *= std::sqrt(past.shear_energy / energy);
}

/// The point of this number among those found.
ContactPoint ContactDetector::State::complete(int number) const {
  const FoundPoint& f = found.points[number];
  ContactPoint p{};
  p.key = f.key;
  for (int k = 0; k < 2; ++k) {
    p.bodies[k] = f.bodies[k];
    p.smooth_faces[k] = f.smooth_faces[k];
  }
  p.joint = f.joint >= 0 ? f.joint : pair_joints.of(p.bodies[0], p.bodies[1]);
  p.position = f.position;
  p.normal = f.normal;
  p.area = f.area;
  const PairScale scale = broad.scale(p.bodies[0], p.bodies[1]);
  p.size = scale.size;

  const JointLaw& law = laws[p.joint];
  const double loaded_area = f.area > 0 ? f.area : scale.size * scale.size;
  const double normal = law.normal_stiffness > 0 ? law.normal_stiffness : scale.stiffness;
  const double shear = law.shear_stiffness > 0 ? law.shear_stiffness : settings.shear_ratio * normal;
  p.normal_stiffness = normal * loaded_area;
  p.shear_stiffness = shear * loaded_area;
  p.friction = law.friction;
  p.restitution = law.restitution;

  p.mode = f.gap > 0 ? ContactMode::open : ContactMode::stick;
  p.shear_start = Vec3::Zero();
  const auto past = memory.transferred_to(number, scale.size);
  p.is_new = !past;
  if (past) {
    go_on_from(*past, f, p);
  } else if (moved[p.bodies[0]] || moved[p.bodies[1]]) {
    p.initial_interference = initial_interference(f, p.normal_stiffness);
  }
  p.gap = f.gap + p.initial_interference;
  return p;
}

void ContactDetector::State::complete_all() {
  by_key_origins.clear();
  memory.transfer(found.points);
  for (int i = 0; i < static_cast<int>(found.points.size()); ++i)
    if (!found.points[i].dropped) by_key_origins.push_back(i);
  by_key.resize(by_key_origins.size());
  const auto complete_some = [&](int first, int last) {
    for (int i = first; i < last; ++i) by_key[i] = complete(by_key_origins[i]);
  };
  in_parallel(static_cast<int>(by_key.size()), contacts_worth_a_thread, std::ref(complete_some));
  handover.limit(memory, by_key_origins, by_key);
  if (joints_bond() || memory.any_bonded()) bond(by_key);
  if (memory.any_broken()) weaken_broken(by_key);
}

/// Bonds of joints that have just come to be, and the strength of all.
void ContactDetector::State::bond(std::span<ContactPoint> points) const {
  for (ContactPoint& p : points) {
    const JointLaw& law = laws[p.joint];
    if (p.is_new && p.area > 0 && !moved[p.bodies[0]] && !moved[p.bodies[1]])
      p.bonded = (law.cohesion > 0 || law.tensile_strength > 0) && p.gap < settings.tolerances.bonded_gap * p.size;
    if (!p.bonded) continue;
    p.cohesion = law.cohesion * p.area;
    p.tension = law.tensile_strength * p.area;
  }
}

void ContactDetector::State::weaken_broken(std::span<ContactPoint> points) const {
  for (std::size_t i = 0; i < points.size(); ++i) {
    ContactPoint& p = points[i];
    p.broken = !p.bonded && memory.ever_broken(found.points[by_key_origins[i]].family);
    if (p.broken) p.friction = laws[p.joint].residual_friction;
  }
}

void ContactDetector::State::write(ContactSet& contacts) {
  complete_all();
  put_in_order();
  hand_out(contacts);
  contacts.sort_out();
  work.points += static_cast<long>(contacts.points.size());
}

/// Those within reach, in the order of their bodies.
void ContactDetector::State::put_in_order() {
  order.clear();
  for (int i = 0; i < static_cast<int>(by_key.size()); ++i) {
    FoundPoint& f = found.points[by_key_origins[i]];
    const ContactPoint& p = by_key[i];
    f.dropped = !p.bonded && !f.is_of_end && p.gap > reach(p.bodies[0], p.bodies[1]);
    if (!f.dropped) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](int p, int q) { return comes_before(by_key[p], by_key[q]); });
}

void ContactDetector::State::hand_out(ContactSet& contacts) {
  const int count = static_cast<int>(order.size());
  contacts.clear();
  contacts.points.resize(count);
  origins.resize(count);
  families.resize(count);
  given_as.assign(found.points.size(), -1);
  int stencils_end = 0;
  for (int i = 0; i < count; ++i) {
    origins[i] = by_key_origins[order[i]];
    given_as[origins[i]] = i;
    contacts.points[i].stencil_begin = stencils_end;
    stencils_end += found.points[origins[i]].stencil_end - found.points[origins[i]].stencil_begin;
  }
  contacts.nodes.resize(stencils_end);
  contacts.weights.resize(stencils_end);
  const auto copy_some = [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const FoundPoint& f = found.points[origins[i]];
      ContactPoint& p = contacts.points[i];
      const int begin = p.stencil_begin;
      p = by_key[order[i]];
      p.stencil_begin = begin;
      p.stencil_end = begin + f.stencil_end - f.stencil_begin;
      std::copy(found.nodes.begin() + f.stencil_begin, found.nodes.begin() + f.stencil_end,
                contacts.nodes.begin() + begin);
      std::copy(found.weights.begin() + f.stencil_begin, found.weights.begin() + f.stencil_end,
                contacts.weights.begin() + begin);
      families[i] = f.family;
    }
  };
  in_parallel(count, contacts_worth_a_thread, std::ref(copy_some));
}

void ContactDetector::detect(std::span<const Vec3> x, const Reach& reach, ContactSet& contacts) {
  State& s = *state_;
  if (!s.settings.motion_told) s.broad.read_motion(x);
  s.reach = reach;
  s.find_points(x);
  s.write(contacts);
  s.coupling.cover(s.found);
}

ContactDetector::UpdatedNormal ContactDetector::updated_normal(int point, std::span<const Vec3> start,
                                                               std::span<const Vec3> end) const {
  const FoundPoint& found = state_->found.points[state_->origins[point]];
  const Vec3 normal = talus::updated_normal(state_->features, found, start, end);
  const Vec3 apart = state_->found.difference(found, [&](int node) { return end[node]; });
  if (found.is_of_end) return {normal, normal.dot(apart)};
  // Of what lies between its places at the start, what lies along its normal is a gap.
  const Vec3 beside = state_->found.difference(found, [&](int node) { return start[node]; }) - found.gap * found.normal;
  return {normal, normal.dot(apart - beside)};
}

/// Which of the points handed out has this key; −1: none.
int ContactDetector::State::given(std::uint64_t key) const {
  const auto same = std::ranges::lower_bound(found.points, key, {}, &FoundPoint::key);
  return same != found.points.end() && same->key == key ? given_as[same - found.points.begin()] : -1;
}

std::span<const ContactDetector::MissedContact> ContactDetector::missed_contacts(std::span<const Vec3> start,
                                                                                 std::span<const Vec3> end,
                                                                                 const Reach& reach, double tolerance) {
  State& s = *state_;
  s.missed.clear();
  if (s.settings.model == ContactModel::facet_wise) return {};
  if (!s.settings.motion_told) s.broad.read_motion(end);
  const StepGeometry step = s.look(end, reach);
  const auto distance = [&](int a, int b) {
    const bool rotates = std::max(reach.ways[a].beside, reach.ways[b].beside) >= tolerance * s.broad.size(a, b);
    const bool surprises = against_each_other(reach.ways[a], reach.ways[b]) > s.reach(a, b);
    return rotates || surprises ? s.search.distance(step, a, b) : -1.0;
  };
  s.search.find_ahead(step, s.broad.find(end, reach, std::ref(distance)), tolerance, s.ahead);
  for (const FoundPoint& point : s.ahead.points) {
    const double size = s.broad.size(point.bodies[0], point.bodies[1]), depth = -point.gap / size;
    if (point.dropped || depth < tolerance) continue;
    double approach = 0;
    for (int k = point.stencil_begin; k < point.stencil_end; ++k)
      approach += s.ahead.weights[k] * point.normal.dot(start[s.ahead.nodes[k]] - end[s.ahead.nodes[k]]);
    const int number = static_cast<int>(&point - s.ahead.points.data());
    s.missed.push_back({.bodies = {point.bodies[0], point.bodies[1]},
                        .position = point.position,
                        .depth = depth,
                        .approach = approach / size,
                        .size = size,
                        .number = number,
                        .given = s.given(point.key)});
  }
  return s.missed;
}

void ContactDetector::take_in(std::span<const MissedContact> missed, std::span<const Vec3> start,
                              ContactSet& contacts) {
  State& s = *state_;
  for (const MissedContact& contact : missed) s.found.add_of_end(s.ahead, s.ahead.points[contact.number], start);
  s.write(contacts);
  s.coupling.cover(s.found);
}

void ContactDetector::moved(int body, double displacement) { state_->broad.moved(body, displacement); }

const std::vector<std::pair<int, int>>& ContactDetector::coupled_nodes() const { return state_->coupling.pairs(); }

std::uint64_t ContactDetector::coupling_generation() const { return state_->coupling.generation(); }

void ContactDetector::accept(const ContactSet& contacts, std::span<const ContactOutcome> outcomes) {
  State& s = *state_;
  if (contacts.points.size() != s.families.size() || outcomes.size() != s.families.size()) {
    throw std::logic_error("ContactDetector::accept: outcomes of another set of contacts");
  }
  s.memory.accept(contacts, s.families, outcomes);
  s.search.accept();
  for (int b = 0; !s.all_have_moved && b < static_cast<int>(s.bodies.size()); ++b) s.moved[b] |= !s.rests(b);
  s.all_have_moved = true;
  for (int body : s.pressed) s.penetration[body] = s.bodies[body].fixed ? 0 : s.memory.resting().deepest(body);
  s.pressed.clear();
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (!(outcomes[i].gap < 0)) continue;
    for (int body : contacts.points[i].bodies) {
      if (s.bodies[body].fixed) continue;
      s.penetration[body] = std::max(s.penetration[body], -outcomes[i].gap);
      s.pressed.push_back(body);
    }
  }
}

void ContactDetector::set_laws(std::vector<JointLaw> laws) { state_->laws = std::move(laws); }

/// What two bodies remember is put aside once both rest, and goes on when one does not any more.
void ContactDetector::State::change_rest(std::span<const int> changed) {
  for (int b : changed) features.set_movable(bodies[b], !rests(b));
  memory.rest(changed, [&](int body) { return rests(body); });
  for (const ContactHistory& history : memory.histories())
    pressed.insert(pressed.end(), history.bodies.begin(), history.bodies.end());
  families.clear();
  all_have_moved = false;
}

void ContactDetector::set_fixed(const std::vector<bool>& fixed) {
  State& s = *state_;
  if (fixed.size() != s.bodies.size()) throw std::logic_error("ContactDetector::set_fixed: not one entry a body");
  std::vector<int> changed;
  for (int b = 0; b < static_cast<int>(fixed.size()); ++b) {
    if (s.bodies[b].fixed != fixed[b]) changed.push_back(b);
    s.bodies[b].fixed = fixed[b];
  }
  s.change_rest(changed);
  s.broad.set_bodies(s.bodies);
  s.coupling.clear();
}

void ContactDetector::set_asleep(const std::vector<char>& asleep) {
  State& s = *state_;
  if (asleep.size() != s.bodies.size()) throw std::logic_error("ContactDetector::set_asleep: not one entry a body");
  std::vector<int> changed;
  for (int b = 0; b < static_cast<int>(asleep.size()); ++b) {
    if (static_cast<bool>(s.asleep[b]) == static_cast<bool>(asleep[b])) continue;
    changed.push_back(b);
    s.asleep[b] = asleep[b];
    s.broad.set_asleep(b, asleep[b]);
  }
  if (changed.empty()) return;
  s.change_rest(changed);
  s.coupling.drop_immovable();
}

std::vector<RestingContact> ContactDetector::resting() const {
  const State& s = *state_;
  std::vector<RestingContact> rows;
  s.memory.resting().list([&](int a, int b) { return !s.bodies[a].fixed || !s.bodies[b].fixed; }, rows);
  return rows;
}

double ContactDetector::spring_energy_at_rest() const { return state_->memory.resting().spring_energy(); }

void ContactDetector::archive(StateArchive& state) {
  State& s = *state_;
  state(s.memory, s.coupling, s.search, s.penetration, s.widths, s.first_areas, s.pressed, s.moved, s.all_have_moved);
  state(s.work);
}

const ContactWork& ContactDetector::work() const { return state_->work; }

const ContactTolerances& ContactDetector::tolerances() const { return state_->settings.tolerances; }

}  // namespace talus
