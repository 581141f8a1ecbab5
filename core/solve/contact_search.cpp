#include "solve/contact_search.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/stopwatch.hpp"
#include "bodies/impulse.hpp"
#include "contact/detection/normal_update.hpp"
#include "solve/awake_bodies.hpp"
#include "solve/simulation_state.hpp"

namespace talus {

namespace {

void limit_springs(SimulationState& s, double length) {
  if (!s.is_on(EffectKind::followed_springs) || s.contacts.points.empty()) return;
  const EffectTimer timer(s.work_of(EffectKind::followed_springs));
  s.followed_springs.limit(s.project, s.adaptive() ? length : s.clock.next_length(), s.penetration(),
                           s.followed_contacts, s.contacts);
}

/// Contacts of all who are awake now.
void seek_for_awake(SimulationState& s, double length) {
  const bool changed = s.sleepers_change;
  if (changed) update_sleepers(s);
  seek_contacts(s, length);
  if (changed) s.energy.awake_changed(s.composition);
  limit_springs(s, length);
}

/// How far gravity takes a body away from what held it in a step [m].
double fall(const SimulationState& s, double length) { return 0.5 * s.project.gravity.norm() * length * length; }

/// How far gaps matter, by the speed of those who may touch somebody [m].
double displacement_reach(const SimulationState& s, double length) {
  double prescribed = 0;
  for (const int b : s.bodies.driven)
    prescribed = std::max(prescribed, s.bodies.nodes.prescribed[s.bodies.bodies[b].first_node].norm());
  const double displacement =
      s.context.dynamic_factor * s.bodies.top_speed(s.company.alone()) * length + fall(s, length);
  return s.tolerances.step.reach_factor * (displacement + prescribed);
}

/// How far two bodies are looked at: by how far they go against each other at the speeds that they have, and by how far
/// gravity may take one away from the other.
void foresee_ways(SimulationState& s, double length) {
  const StepTolerances& t = s.tolerances.step;
  s.reach.least = t.reach_factor * fall(s, length) + t.least_reach * s.smallest_size;
  s.reach.multiple = t.reach_factor;
  s.bodies.find_ways(s.context.dynamic_factor * length, s.company.alone(), s.reach.ways);
}

/// Pairs of degree-of-freedom blocks that contacts couple or may couple soon.
std::vector<std::pair<int, int>> couplings_of_contacts(const SimulationState& s) {
  std::vector<std::pair<int, int>> couplings;
  std::vector<int> dof_blocks, others;
  for (const auto& [i, j] : s.detector.coupled_nodes()) {
    s.bodies.dof_blocks_of(i, dof_blocks);
    s.bodies.dof_blocks_of(j, others);
    for (const int a : dof_blocks)
      for (const int b : others)
        if (a != b) couplings.emplace_back(a, b);
  }
  return couplings;
}

/// Where nodes will be in the middle of the step, if bodies go on as they do.
void foresee_middle(SimulationState& s, double length) {
  const NodeSet& nodes = s.bodies.nodes;
  s.foreseen = nodes.position;
  const auto go_on = [&](const std::vector<int>& bodies, const std::vector<Vec3>& motion, double times) {
    for (const int b : bodies) {
      const Body& body = s.bodies.bodies[b];
      for (int n = body.first_node; n < body.first_node + body.node_count; ++n) s.foreseen[n] += times * motion[n];
    }
  };
  go_on(s.bodies.moving, nodes.velocity, 0.5 * length);
  go_on(s.bodies.driven, nodes.prescribed, 0.5);
}

/// Normals of contacts in the middle of the step, if bodies go on as they do. Faces of bodies that deform swing with
/// their waves: what they do next their velocities do not tell.
void foresee_normals(SimulationState& s, double length) {
  if (!s.dynamic() || !s.is_on(EffectKind::updated_normals)) return;
  const EffectTimer timer(s.work_of(EffectKind::updated_normals));
  foresee_middle(s, length);
  const auto deforms = [&](int b) { return !s.bodies.bodies[b].fixed && s.bodies.bodies[b].rigid < 0; };
  const auto sliding = [&](const ContactPoint& point) -> Vec3 {
    if (deforms(point.bodies[0]) || deforms(point.bodies[1])) return Vec3::Zero();
    const auto [nodes, weights] = s.contacts.stencil(point);
    return length * velocity_of(s.bodies, nodes, weights, length);
  };
  const auto middle_normal = [&](int point) {
    return s.detector.updated_normal(point, s.bodies.nodes.position, s.foreseen).normal;
  };
  foresee_normals(s.contacts, sliding, middle_normal, s.detector.tolerances());
}

/// Contacts were sought anew: attaches them to bodies, and says which rigid ones touch others that move.
void connect(SimulationState& s) {
  for (RigidBody& rigid : s.bodies.rigid) rigid.touches = false;
  const auto turns = [&](int body) { return s.bodies.bodies[body].rigid >= 0 && !s.bodies.bodies[body].fixed; };
  if (s.context.arms == Arms::mean)
    for (const ContactPoint& point : s.contacts.points) {
      if (!turns(point.bodies[0]) || !turns(point.bodies[1])) continue;
      for (const int body : point.bodies) s.bodies.rigid[s.bodies.bodies[body].rigid].touches = true;
    }
  s.links.connect(s.context.arms);
}

void follow_couplings(SimulationState& s) {
  if (s.pattern_generation == s.detector.coupling_generation()) return;
  s.pattern_generation = s.detector.coupling_generation();
  s.open_close.set_pattern(s.bodies.nodes.movable, couplings_of_contacts(s));
}

/// Those that go on as they are when the missed ones are taken in, in their order.
std::vector<ContactPoint> corrected_so_far(const ContactSet& contacts,
                                           std::span<const ContactDetector::MissedContact> missed) {
  std::vector<char> begins_anew(contacts.points.size(), 0);
  for (const auto& contact : missed)
    if (contact.given >= 0) begins_anew[contact.given] = 1;
  std::vector<ContactPoint> corrected;
  for (std::size_t i = 0; i < contacts.points.size(); ++i)
    if (!begins_anew[i]) corrected.push_back(contacts.points[i]);
  return corrected;
}

/// The normals and springs that a step has come to so far: it would only come to them again.
void keep_corrections(const std::vector<ContactPoint>& corrected, ContactSet& contacts) {
  for (ContactPoint& point : contacts.points) {
    const auto same = std::ranges::lower_bound(corrected, point, comes_before);
    if (same == corrected.end() || same->key != point.key) continue;
    point.normal = same->normal;
    point.gap = same->gap;
    point.initial_interference = same->initial_interference;
    point.shear_start = same->shear_start;
    point.normal_stiffness = same->normal_stiffness;
    point.shear_stiffness = same->shear_stiffness;
    point.penalty_scaling = same->penalty_scaling;
    point.stiffened = same->stiffened;
  }
}

}  // namespace

void look_for_company(SimulationState& s, double reach) {
  // Detection was not told of those who were alone.
  for (int b = 0; b < static_cast<int>(s.bodies.bodies.size()); ++b)
    if (s.company.is_alone(b) && s.company.travelled(b) > 0) s.detector.moved(b, s.company.travelled(b));
  const double ahead =
      std::min(s.clock.left(), s.tolerances.step.foreseen_steps * s.project.stages[s.clock.stage()].time_step);
  s.company.look(s.bodies, ahead, reach);
}

void let_touch(SimulationState& s) {
  if (!s.company.any() || !s.composition.normal.empty()) return;
  const PutIn where = put_in_contact(s.composition, s.project, s.system, s.tolerances.effects);
  s.open_close.put_in(where);
  s.energy.put_in(s.composition, where);
  s.pattern_generation = ~0ull;
  s.expect_impacts();
}

void seek_contacts(SimulationState& s, double length) {
  s.open_close.release_states();
  double reach = displacement_reach(s, length);
  if (s.company.is_due(reach + s.smallest_size)) {
    look_for_company(s, reach + s.smallest_size);
    let_touch(s);
    reach = displacement_reach(s, length);
  }
  s.context.reach = reach + s.smallest_size;
  s.context.unlimited = s.dynamic() && s.company.any_alone() ? s.company.alone() : std::span<const char>();
  if (!s.company.any() && s.contacts.points.empty()) return connect(s);
  foresee_ways(s, length);
  s.detector.detect(s.bodies.nodes.position, s.reach, s.contacts);
  foresee_normals(s, length);
  connect(s);
}

void detect_contacts(SimulationState& s, double length) {
  const Stopwatch watch(s.detect_seconds);
  seek_for_awake(s, length);
  follow_couplings(s);
}

bool take_in(SimulationState& s, std::span<const ContactDetector::MissedContact> missed) {
  const Stopwatch watch(s.detect_seconds);
  const auto sleeps = [&](int body) { return s.sleep.asleep()[body] != 0; };
  if (std::any_of(missed.begin(), missed.end(),
                  [&](const auto& contact) { return sleeps(contact.bodies[0]) || sleeps(contact.bodies[1]); }))
    return false;
  const std::vector<ContactPoint> corrected = corrected_so_far(s.contacts, missed);
  s.detector.take_in(missed, s.bodies.nodes.position, s.contacts);
  connect(s);
  limit_springs(s, s.context.length);
  keep_corrections(corrected, s.contacts);
  follow_couplings(s);
  s.open_close.begin_step(s.context);
  return true;
}

}  // namespace talus
