#include "contact/contact_detector.hpp"

#include <algorithm>
#include <stdexcept>

#include "contact/broad_phase.hpp"
#include "contact/contact_memory.hpp"
#include "contact/contact_points.hpp"
#include "contact/coupling.hpp"
#include "contact/features.hpp"

namespace talus {
namespace {

constexpr double bonded_gap = 1e-3;   // of the size: facets that are nearer at the start are one joint
constexpr double reach_slack = 1e-9;  // of the size, for the rounding of two ways to measure one gap

}  // namespace

struct ContactDetector::State {
  State(std::vector<ContactBody> b, std::vector<JointLaw> l, std::vector<std::vector<int>> joints, ContactSettings s)
      : bodies(std::move(b)),
        laws(std::move(l)),
        pair_joint(std::move(joints)),
        settings(s),
        features(bodies),
        broad(features, bodies, settings),
        memory(s.model == ContactModel::facet_wise),
        coupling(features),
        penetration(bodies.size(), 0.0),
        moved(bodies.size(), 0) {}

  double bond_reach() const;
  void keep_near_pairs(std::span<const FacetPair> pairs, std::span<const Vec3> x, double reach);
  void find_points(std::span<const Vec3> x, double reach);
  double late_overlap(const FoundPoint& found) const;
  ContactPoint complete(const FoundPoint& found);
  void write(double reach, ContactSet& contacts);

  std::vector<ContactBody> bodies;
  std::vector<JointLaw> laws;
  std::vector<std::vector<int>> pair_joint;
  ContactSettings settings;
  ContactFeatures features;
  BroadPhase broad;
  FacetWiseSearch facet_wise;
  FacingSearch facing;
  VertexSearch vertices;
  EdgeSearch edges;
  ContactMemory memory;
  Coupling coupling;
  std::vector<double> penetration;  // m, a movable body: the deepest of the last step
  std::vector<char> moved;          // a body: it took part in a step and was not fixed

  std::vector<FacetPair> near;
  FoundPoints found;
  std::vector<std::uint64_t> families;  // of the points handed out
};

ContactDetector::ContactDetector(std::vector<ContactBody> bodies, std::vector<JointLaw> laws,
                                 std::vector<std::vector<int>> pair_joint, ContactSettings settings)
    : state_(std::make_unique<State>(std::move(bodies), std::move(laws), std::move(pair_joint), settings)) {}

ContactDetector::~ContactDetector() = default;

/// A bond of a soft joint holds over a gap that no step's displacement would reach.
double ContactDetector::State::bond_reach() const {
  double widest = 0;
  for (const JointLaw& law : laws) {
    if (law.normal_stiffness > 0) widest = std::max(widest, law.tensile_strength / law.normal_stiffness);
  }
  return widest;
}

/// The planes of both facets tell most of the pairs that are apart; the boxes know it only along the axes.
void ContactDetector::State::keep_near_pairs(std::span<const FacetPair> pairs, std::span<const Vec3> x, double reach) {
  near.clear();
  const std::span<const Vec3> normals = broad.normals();
  const auto apart = [&](int facet, int from, double distance) {
    const auto &n = features.facets[facet].nodes, &m = features.facets[from].nodes;
    const Vec3 &normal = normals[from], &origin = x[m[0]];
    const double h0 = normal.dot(x[n[0]] - origin), h1 = normal.dot(x[n[1]] - origin),
                 h2 = normal.dot(x[n[2]] - origin);
    return std::min({h0, h1, h2}) > distance || std::max({h0, h1, h2}) < -distance;
  };
  int body_a = -1, body_b = -1;
  double distance = 0;
  for (const FacetPair& pair : pairs) {
    const int a = features.facets[pair.a].body, b = features.facets[pair.b].body;
    if (a != body_a || b != body_b) {
      body_a = a, body_b = b;
      distance = broad.search_distance(a, b, reach) + reach_slack * broad.scale(a, b).size;
    }
    if (!apart(pair.a, pair.b, distance) && !apart(pair.b, pair.a, distance)) near.push_back(pair);
  }
}

void ContactDetector::State::find_points(std::span<const Vec3> x, double reach) {
  keep_near_pairs(broad.find(x, reach), x, reach);
  const StepGeometry step{features, broad, x, broad.normals(), penetration, settings, reach, moved};
  found.clear();
  if (settings.model == ContactModel::facet_wise) {
    facet_wise.find(step, near, found);
  } else {
    facing.find(step, near, found);
    vertices.find(step, near, found);
    edges.find(step, near, vertices, found);
  }
  std::sort(found.points.begin(), found.points.end(),
            [](const FoundPoint& p, const FoundPoint& q) { return p.key < q.key; });
}

/// A contact that shows up deeper than any was in the last step was there before and was not seen, where features give
/// way to one another. It pushes against what comes on top: pushing back all of it would make energy from nothing.
double ContactDetector::State::late_overlap(const FoundPoint& f) const {
  return std::max(0.0, -f.gap - std::max(penetration[f.bodies[0]], penetration[f.bodies[1]]));
}

ContactPoint ContactDetector::State::complete(const FoundPoint& f) {
  ContactPoint p{};
  p.key = f.key;
  for (int k = 0; k < 2; ++k) {
    p.bodies[k] = f.bodies[k];
    p.patches[k] = f.patches[k];
  }
  p.joint = f.joint >= 0 ? f.joint : pair_joint[p.bodies[0]][p.bodies[1]];
  p.position = f.position;
  p.normal = f.normal;
  p.gap = f.gap;
  p.area = f.area;
  const PairScale scale = broad.scale(p.bodies[0], p.bodies[1]);
  p.size = scale.size;

  const JointLaw& law = laws[p.joint];
  const double loaded_area = f.area > 0 ? f.area : scale.size * scale.size;
  const double normal = law.normal_stiffness > 0 ? law.normal_stiffness : scale.stiffness;
  const double shear = law.shear_stiffness > 0 ? law.shear_stiffness : settings.shear_ratio * normal;
  p.normal_stiffness = normal * loaded_area;
  p.shear_stiffness = shear * loaded_area;

  p.mode = f.gap > 0 ? ContactMode::open : ContactMode::stick;
  p.shear_start = Vec3::Zero();
  if (const auto past = memory.recall(f, scale.size)) {
    p.bonded = past->bonded && f.area > 0;
    p.mode = past->mode;
    p.shear_start = past->shear;
    p.multiplier = past->multiplier;
    p.slip_start = past->slip;
    p.overlap = past->overlap;
    // A vertex is stiffer than the corner of an area that it was: the same gap would push harder all of a sudden.
    if (past->lost_area) p.overlap = std::max(p.overlap, -f.gap - past->spring_force / p.normal_stiffness);
  } else if (moved[p.bodies[0]] || moved[p.bodies[1]]) {
    p.overlap = late_overlap(f);
  } else if (f.area > 0) {
    p.bonded = (law.cohesion > 0 || law.tensile_strength > 0) && f.gap < bonded_gap * scale.size;
  }
  p.gap = f.gap + p.overlap;
  p.friction = !p.bonded && memory.ever_broken(f.family) ? law.residual_friction : law.friction;
  p.cohesion = p.bonded ? law.cohesion * f.area : 0;
  p.tension = p.bonded ? law.tensile_strength * f.area : 0;
  return p;
}

void ContactDetector::State::write(double reach, ContactSet& contacts) {
  contacts.clear();
  families.clear();
  memory.claim(found.points);
  for (FoundPoint& f : found.points) {
    if (f.dropped) continue;
    ContactPoint p = complete(f);
    f.dropped = !p.bonded && p.gap > reach;
    if (f.dropped) continue;
    p.stencil_begin = static_cast<int>(contacts.nodes.size());
    contacts.nodes.insert(contacts.nodes.end(), found.nodes.begin() + f.stencil_begin,
                          found.nodes.begin() + f.stencil_end);
    contacts.weights.insert(contacts.weights.end(), found.weights.begin() + f.stencil_begin,
                            found.weights.begin() + f.stencil_end);
    p.stencil_end = static_cast<int>(contacts.nodes.size());
    contacts.points.push_back(p);
    families.push_back(f.family);
  }
}

void ContactDetector::detect(std::span<const Vec3> x, double reach, ContactSet& contacts) {
  State& s = *state_;
  s.find_points(x, std::max(reach, s.bond_reach()));
  s.write(reach, contacts);
  s.coupling.cover(s.found);
}

const std::vector<std::pair<int, int>>& ContactDetector::coupled_nodes() const { return state_->coupling.pairs(); }

std::uint64_t ContactDetector::coupling_generation() const { return state_->coupling.generation(); }

void ContactDetector::accept(const ContactSet& contacts, std::span<const ContactOutcome> outcomes) {
  State& s = *state_;
  if (contacts.points.size() != s.families.size() || outcomes.size() != s.families.size()) {
    throw std::logic_error("ContactDetector::accept: outcomes of another set of contacts");
  }
  s.memory.accept(contacts.points, s.families, outcomes, [&](int body) { return s.bodies[body].fixed; });
  for (std::size_t b = 0; b < s.bodies.size(); ++b) s.moved[b] = s.moved[b] || !s.bodies[b].fixed;
  std::fill(s.penetration.begin(), s.penetration.end(), 0.0);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    for (int body : contacts.points[i].bodies) {
      if (!s.bodies[body].fixed) s.penetration[body] = std::max(s.penetration[body], -outcomes[i].gap);
    }
  }
}

void ContactDetector::set_laws(std::vector<JointLaw> laws) { state_->laws = std::move(laws); }

void ContactDetector::set_fixed(const std::vector<bool>& fixed) {
  State& s = *state_;
  if (fixed.size() != s.bodies.size()) throw std::logic_error("ContactDetector::set_fixed: not one entry a body");
  for (std::size_t b = 0; b < fixed.size(); ++b) {
    s.bodies[b].fixed = fixed[b];
    s.features.set_movable(s.bodies[b], !fixed[b]);
  }
  s.broad.set_bodies(s.bodies);
  s.coupling.clear();
}

}  // namespace talus
