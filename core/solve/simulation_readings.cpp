#include <algorithm>

#include "solve/simulation_state.hpp"

/// What can be read of a simulation between steps.
namespace talus {

std::vector<Voigt> Simulation::present_stress() const {
  const State& s = *state_;
  s.stress_recoveries += static_cast<long>(s.bodies.moving.size());
  std::vector<Voigt> stress(s.bodies.elements.size(), Voigt::Zero());
  for (const auto& effect : s.composition.effects) effect->add_stress(stress);
  return stress;
}

std::vector<Voigt> Simulation::stress_of(int index, const std::vector<Voigt>& stress) const {
  const Body& body = state_->bodies.bodies[index];
  if (body.fixed) return state_->bodies.stress_of_held(index);
  const auto first = stress.begin() + body.first_element;
  return {first, first + body.element_count};
}

Voigt Simulation::stress_at(const MaterialPoint& point, const std::vector<Voigt>& stress) const {
  const std::vector<Voigt> own = stress_of(point.body, stress);
  return own.size() == 1 ? own.front() : own.at(static_cast<std::size_t>(point.tetrahedron));
}

Frame Simulation::frame(int index) const {
  const State& s = *state_;
  Frame frame;
  frame.index = index;
  frame.time = time();
  frame.stage = stage();
  const NodeSet& nodes = s.bodies.nodes;
  for (int n = 0; n < nodes.of_blocks; ++n) frame.displacement.push_back(nodes.position[n] - nodes.reference[n]);
  frame.velocity.assign(nodes.velocity.begin(), nodes.velocity.begin() + nodes.of_blocks);
  const std::vector<Voigt> stress = present_stress();
  for (std::size_t b = 0; b < s.bodies.bodies.size(); ++b) {
    const Body& body = s.bodies.bodies[b];
    const std::size_t tetrahedra = s.system.blocks[b].mesh.tetrahedra.size();
    std::vector<Voigt> own = stress_of(static_cast<int>(b), stress);
    own.resize(tetrahedra, body.kind == BodyKind::affine && !own.empty() ? own.front() : Voigt(Voigt::Zero()));
    frame.stress.insert(frame.stress.end(), own.begin(), own.end());
  }
  frame.contacts = contacts();
  return frame;
}

const std::vector<ContactSample>& Simulation::awake_contacts() const { return state_->outcomes.samples(); }

std::vector<ContactSample> Simulation::contacts() const {
  std::vector<ContactSample> samples = awake_contacts();
  for (const RestingContact& resting : state_->resting) samples.push_back(sample_of(resting));
  return samples;
}

HistoryRow Simulation::history() const {
  const State& s = *state_;
  HistoryRow row;
  row.time = time();
  row.stage = stage();
  const NodeSet& nodes = s.bodies.nodes;
  const auto watched = [](const Monitor& monitor) { return monitor.stress; };
  const bool any = std::any_of(s.project.monitors.begin(), s.project.monitors.end(), watched);
  const std::vector<Voigt> stress = any ? present_stress() : std::vector<Voigt>();
  for (std::size_t i = 0; i < s.monitors.size(); ++i) {
    const MaterialPoint& point = s.monitors[i];
    MonitorSample sample{point.at(nodes.position) - point.at(nodes.reference), point.at(nodes.velocity), {}};
    if (s.project.monitors[i].stress) sample.stress = stress_at(point, stress);
    row.monitors.push_back(sample);
  }
  return row;
}

std::vector<EffectOutcome> Simulation::effects() const {
  const State& s = *state_;
  auto work = s.open_close.balance().effect_work();
  if (s.impacts)
    work["rebound"] = {.seconds = s.impacts->seconds(), .built = 1, .evaluations = s.impacts->evaluations()};
  std::vector<EffectOutcome> outcomes;
  for (const EffectStatus& status : called_effects(s.project, s.system)) {
    EffectOutcome& outcome = outcomes.emplace_back(EffectOutcome{status.name, status.active, status.reason});
    const auto spent = work.find(status.name);
    if (spent == work.end()) continue;
    outcome.seconds = spent->second.seconds;
    outcome.built = spent->second.built;
    outcome.evaluations = spent->second.evaluations;
    outcome.assemblies = spent->second.assemblies;
  }
  return outcomes;
}

RunWork Simulation::work() const {
  const State& s = *state_;
  const ContactWork& contact = s.detector.work();
  const LinearWork& linear = s.open_close.linear_work();
  RunWork work;
  work.body_pairs = contact.body_pairs;
  work.facet_searches = contact.searches;
  work.facet_pairs = contact.facet_pairs;
  work.contact_points = contact.points;
  work.factorisations = linear.factorisations;
  work.dense_factorisations = linear.dense_factorisations;
  work.linear_solves = linear.solves;
  work.gmres_iterations = linear.gmres_iterations;
  work.systems = linear.systems;
  work.largest_system = linear.largest_system;
  work.block_steps_asleep = s.block_steps_asleep;
  work.wakings = s.sleep.wakings();
  work.stress_recoveries = s.stress_recoveries;
  return work;
}

}  // namespace talus
