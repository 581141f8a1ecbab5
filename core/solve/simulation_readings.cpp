#include <algorithm>

#include "solve/contact_search.hpp"
#include "solve/simulation.hpp"
#include "solve/simulation_state.hpp"
#include "solve/stage_start.hpp"

/// How a simulation begins, and what can be read of it between steps.
namespace talus {

Simulation::Simulation(const Project& project, const BlockSystem& system, const Tolerances& tolerances)
    : state_(std::make_unique<SimulationState>(project, system, tolerances)) {
  begin_stage(*state_);
}
Simulation::~Simulation() = default;

bool Simulation::finished() const { return !converged() || state_->clock.finished(); }
bool Simulation::stage_ended() const { return state_->clock.stage_ended(); }
bool Simulation::stage_ends() const {
  const SimulationState& s = *state_;
  if (finished()) return false;
  return s.adaptive() ? s.control.length() >= s.clock.left() : s.clock.is_last();
}
bool Simulation::converged() const { return !state_->troubles.run_ended(); }
std::string Simulation::failure() const { return converged() ? "" : failure_text(troubles().back()); }
const std::vector<ConvergenceTrouble>& Simulation::troubles() const { return state_->troubles.all(); }
int Simulation::stage() const {
  const StageClock& clock = state_->clock;
  return clock.stage_ended() ? clock.stage() - 1 : clock.stage();
}
double Simulation::time() const { return state_->clock.time(); }
double Simulation::end_time() const { return state_->clock.end(); }
long Simulation::total_steps() const { return state_->clock.total_steps(); }
const BodySet& Simulation::bodies() const { return state_->bodies; }
const Vec3& Simulation::origin() const { return state_->model.origin(); }

const ContactSet& Simulation::look_for_contacts() {
  SimulationState& s = *state_;
  if (s.anything_moves()) seek_contacts(s, s.adaptive() ? s.control.length() : s.clock.next_length());
  return s.contacts;
}

void Simulation::watch_iterations(std::function<void(double unbalanced)> each_iteration) {
  state_->open_close.watch(std::move(each_iteration));
}

Frame Simulation::frame(int index) const {
  const SimulationState& s = *state_;
  Frame frame = moment({});
  frame.index = index;
  const std::vector<Voigt> stress = s.stress.all();
  for (std::size_t b = 0; b < s.bodies.bodies.size(); ++b) {
    const Body& body = s.bodies.bodies[b];
    const std::size_t tetrahedra = s.system.blocks[b].mesh.tetrahedra.size();
    std::vector<Voigt> own = s.stress.of_body(static_cast<int>(b), stress);
    own.resize(tetrahedra, body.kind == BodyKind::affine && !own.empty() ? own.front() : Voigt(Voigt::Zero()));
    frame.stress.insert(frame.stress.end(), own.begin(), own.end());
  }
  return frame;
}

Frame Simulation::moment(const Frame& earlier) const {
  const SimulationState& s = *state_;
  Frame frame;
  frame.index = earlier.index;
  frame.time = time();
  frame.stage = stage();
  const NodeSet& nodes = s.bodies.nodes;
  for (int n = 0; n < nodes.of_blocks; ++n) frame.displacement.push_back(nodes.position[n] - nodes.reference[n]);
  frame.velocity.assign(nodes.velocity.begin(), nodes.velocity.begin() + nodes.of_blocks);
  frame.stress = earlier.stress;
  frame.contacts = contacts();
  frame.motions = earlier.motions;
  frame.asleep = s.sleep.asleep();
  return frame;
}

const std::vector<ContactSample>& Simulation::awake_contacts() const { return state_->outcomes.samples(); }

std::vector<ContactSample> Simulation::contacts() const {
  std::vector<ContactSample> samples = awake_contacts();
  for (const RestingContact& resting : state_->resting) samples.push_back(sample_of(resting));
  for (ContactSample& sample : samples) sample.position += state_->model.origin();
  return samples;
}

HistoryRow Simulation::history() const {
  const SimulationState& s = *state_;
  HistoryRow row;
  row.time = time();
  row.stage = stage();
  const NodeSet& nodes = s.bodies.nodes;
  const auto watched = [](const Monitor& monitor) { return monitor.stress; };
  const bool any = std::any_of(s.project.monitors.begin(), s.project.monitors.end(), watched);
  const std::vector<Voigt> stress = any ? s.stress.all() : std::vector<Voigt>();
  for (std::size_t i = 0; i < s.monitors.size(); ++i) {
    const MaterialPoint& point = s.monitors[i];
    MonitorSample sample{point.at(nodes.position) - point.at(nodes.reference), point.at(nodes.velocity), {}};
    if (s.project.monitors[i].stress) sample.stress = s.stress.at(point, stress);
    row.monitors.push_back(sample);
  }
  return row;
}

namespace {

/// What all effects have cost, those that are no term of the potential too.
std::map<EffectKind, StepResidual::EffectWork> effect_work(const SimulationState& s,
                                                           const std::vector<EffectStatus>& called) {
  auto work = s.open_close.residual().effect_work();
  if (s.impacts) {
    work[EffectKind::rebound] = {.seconds = s.impacts->seconds(), .built = 1, .evaluations = s.impacts->evaluations()};
    work[EffectKind::restitution].evaluations = s.impacts->restitutions();
  }
  for (const EffectStatus& status : called) {
    if (status.kind <= EffectKind::damping || !status.active) continue;
    StepResidual::EffectWork& of_kind = work[status.kind];
    const StepResidual::EffectWork& counted = status.kind == EffectKind::elimination
                                                  ? s.open_close.work_alone()
                                                  : s.extra_work[static_cast<std::size_t>(status.kind)];
    of_kind.seconds += counted.seconds;
    of_kind.evaluations += counted.evaluations;
    of_kind.built = 1;
  }
  return work;
}

}  // namespace

std::vector<EffectOutcome> Simulation::effects() const {
  const SimulationState& s = *state_;
  const std::vector<EffectStatus> called = called_effects(s.project, s.system, s.company.never_met(s.bodies));
  const auto work = effect_work(s, called);
  std::vector<EffectOutcome> outcomes;
  for (const EffectStatus& status : called) {
    EffectOutcome& outcome =
        outcomes.emplace_back(EffectOutcome{std::string(to_string(status.kind)), status.active, status.reason});
    const auto spent = work.find(status.kind);
    if (spent == work.end()) continue;
    outcome.seconds = spent->second.seconds;
    outcome.built = spent->second.built;
    outcome.evaluations = spent->second.evaluations;
    outcome.assemblies = spent->second.assemblies;
  }
  return outcomes;
}

RunWork Simulation::work() const {
  const SimulationState& s = *state_;
  const ContactWork& contact = s.detector.work();
  const LinearWork linear = s.open_close.linear_work();
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
  work.correction_limits = s.correction_limits;
  work.impact_sweep_limits = s.impacts ? s.impacts->sweep_limits() : 0;
  work.gmres_limits = linear.gmres_limits;
  work.failed_factorisations = s.open_close.interior_point().failed_factorisations();
  work.stress_recoveries = s.stress.count();
  return work;
}

}  // namespace talus
