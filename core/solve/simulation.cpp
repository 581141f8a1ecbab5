#include "solve/simulation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/contact_detector.hpp"
#include "effects/in_situ_stress.hpp"
#include "model/stage_changes.hpp"
#include "solve/contact_outcomes.hpp"
#include "solve/energy_balance.hpp"
#include "solve/first_guess.hpp"
#include "solve/initial_motion.hpp"
#include "solve/joint_laws.hpp"
#include "solve/prescribed_motion.hpp"
#include "solve/stage_clock.hpp"
#include "solve/step_control.hpp"
#include "solve/stopwatch.hpp"

namespace talus {

namespace {

/// A step that does not settle is cut by this factor, and grows back by it …
constexpr double cut_factor = 3;
/// … but is never shorter than this share of the stage's step: then the run has not converged.
constexpr double shortest_share = 0.01;
/// Contacts are sought within this many times the way that a node can make in the step …
constexpr double reach_factor = 2.5;
/// … and this share of the smallest mesh size, so that touching faces are found at rest.
constexpr double reach_share = 1e-3;
/// Rounds of the augmented Lagrangian in a step; each brings penetration down by about the contact's over the rock's
/// stiffness.
constexpr int augmentation_limit = 10;
/// A static stage is in equilibrium no sooner than after this many steps.
constexpr int fewest_static_steps = 2;

std::vector<Surface> surfaces_of(const BlockSystem& system) {
  std::vector<Surface> surfaces;
  for (const Block& block : system.blocks) surfaces.push_back(make_surface(block.mesh.nodes, block.surface));
  return surfaces;
}

std::vector<ContactBody> contact_bodies(const BodySet& set, const std::vector<Surface>& surfaces) {
  std::vector<ContactBody> bodies;
  for (std::size_t b = 0; b < set.bodies.size(); ++b)
    bodies.push_back({&surfaces[b], set.bodies[b].first_node, set.bodies[b].fixed, set.bodies[b].young,
                      set.bodies[b].one_piece()});
  return bodies;
}

ContactSettings contact_settings(const Project& project) {
  ContactSettings settings;
  settings.model = project.solver.contact;
  settings.stiffness = project.solver.contact_stiffness;
  settings.motion_told = true;
  return settings;
}

OpenCloseSettings open_close_settings(const Project& project) {
  OpenCloseSettings settings;
  settings.iteration_limit = project.solver.open_close_limit;
  return settings;
}

double smallest_mesh_size(const BodySet& bodies, const std::vector<Surface>& surfaces) {
  double size = 1e300;
  for (std::size_t b = 0; b < bodies.bodies.size(); ++b)
    if (!bodies.bodies[b].built_fixed()) size = std::min(size, surfaces[b].size);
  return size;
}

/// Half the height of all blocks [m]; of a flat model half its longest side.
double half_height(const BodySet& bodies) {
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (const Vec3& x : bodies.nodes.reference) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const Vec3 sides = high - low;
  return 0.5 * (sides.z() > 0 ? sides.z() : sides.maxCoeff());
}

}  // namespace

struct Simulation::State {
  State(const Project& p, const BlockSystem& s)
      : project(p),
        system(s),
        bodies(p, s),
        clock(p.stages),
        surfaces(surfaces_of(s)),
        smallest_size(smallest_mesh_size(bodies, surfaces)),
        detector(contact_bodies(bodies, surfaces), joint_laws(p), pair_joints(p, s), contact_settings(p)),
        open_close(open_close_settings(p)),
        control(p.solver.adaptive, half_height(bodies), smallest_size) {
    for (const Monitor& monitor : p.monitors) {
      const double tolerance = 1e-6 * std::cbrt(s.solids_volume);
      monitors.push_back(material_point(s, monitor.block, monitor.at, tolerance, "monitor '" + monitor.name + "'"));
    }
    bodies.stress = stress_before(p, s, bodies);
    for (const Vec3& x : bodies.nodes.reference) context.extent = std::max(context.extent, x.cwiseAbs().maxCoeff());
    for (const Surface& surface : surfaces) context.mesh_size = std::max(context.mesh_size, surface.size);
  }

  bool adaptive() const { return project.solver.time_step_control == TimeStepControl::adaptive; }
  bool augmented() const { return project.solver.penetration_tolerance.has_value(); }

  const Project& project;
  const BlockSystem& system;
  BodySet bodies;
  StageClock clock;
  std::vector<Surface> surfaces;
  double smallest_size;  ///< m
  ContactDetector detector;
  ContactSet contacts;
  ContactLinks links{bodies, contacts};
  ContactOutcomes outcomes;
  Composition composition;
  OpenClose open_close;
  FirstGuess first_guess;
  StepControl control;
  EnergyBalance energy;
  std::optional<PrescribedMotion> motion;
  std::vector<MaterialPoint> monitors;
  std::vector<bool> held;
  StepContext context;  ///< of the step that is tried
  Increment increment;
  double trial_length = 1e300;  ///< s, what the next step is tried with
  std::uint64_t pattern_generation = ~0ull;
  bool velocities_given = false, accelerations_wanted = false;
  double detect_seconds = 0;
  int step = 0, stage_steps = 0;
};

Simulation::Simulation(const Project& project, const BlockSystem& system)
    : state_(std::make_unique<State>(project, system)) {
  begin_stage();
}
Simulation::~Simulation() = default;

bool Simulation::finished() const { return !converged() || state_->clock.finished(); }
bool Simulation::stage_ended() const { return state_->clock.stage_ended(); }
int Simulation::stage() const {
  const StageClock& clock = state_->clock;
  return clock.stage_ended() ? clock.stage() - 1 : clock.stage();
}
double Simulation::time() const { return state_->clock.time(); }
double Simulation::end_time() const { return state_->clock.end(); }
long Simulation::total_steps() const { return state_->clock.total_steps(); }
const BodySet& Simulation::bodies() const { return state_->bodies; }

void Simulation::hold_blocks(int stage) {
  State& s = *state_;
  const std::vector<std::string> names = blocks_held_in_stage(s.project, stage);
  std::vector<bool> held, fixed;
  for (std::size_t b = 0; b < s.bodies.bodies.size(); ++b) {
    held.push_back(std::find(names.begin(), names.end(), s.system.blocks[b].name) != names.end());
    fixed.push_back(held.back() || s.bodies.bodies[b].built_fixed());
  }
  if (held == s.held) return;
  s.held = held;
  if (!s.composition.effects.empty()) s.bodies.stress = present_stress();
  s.bodies.hold(held);
  s.detector.set_fixed(fixed);
}

void Simulation::begin_stage() {
  State& s = *state_;
  const int number = s.clock.stage();
  const Stage& stage = s.project.stages[number];
  const Project now = project_in_stage(s.project, number);
  hold_blocks(number);
  s.detector.set_laws(joint_laws(now));
  s.open_close.end_stage();
  s.composition = compose(s.project, s.system, number, s.bodies, s.links);
  s.open_close.begin_stage(s.composition);
  s.energy.begin_stage(s.composition);
  s.motion.emplace(now, s.system);
  std::fill(s.bodies.nodes.prescribed.begin(), s.bodies.nodes.prescribed.end(), Vec3::Zero());
  s.control.begin_stage(stage.time_step);
  s.pattern_generation = ~0ull;
  s.increment.setZero(s.bodies.unknowns());
  s.first_guess.forget(s.bodies.unknowns());
  s.stage_steps = 0;
  s.context.dynamic_factor = stage.kind == StageKind::dynamic ? 1 : 0;
  s.context.integration = TimeIntegration::of(s.project.solver);
  if (stage.kind == StageKind::static_ && s.context.integration.alpha_f > 0)
    s.context.integration = TimeIntegration::newmark();
  s.accelerations_wanted = stage.kind == StageKind::dynamic;
  if (stage.kind == StageKind::dynamic && !s.velocities_given) {
    give_initial_velocities(s.project, s.system, s.bodies);
    s.energy.energy_was_given(s.composition);
    s.velocities_given = true;
  }
}

StepReport Simulation::step() {
  State& s = *state_;
  if (s.clock.stage_begins() && s.step > 0) begin_stage();
  StepReport report;
  report.step = ++s.step;
  report.stage = s.clock.stage();
  const double start = s.clock.time();
  const SolveTimes before = s.open_close.times();
  const double detect_before = s.detect_seconds;
  if (s.adaptive())
    take_adaptive_step(report);
  else
    take_fixed_step(report);
  ++s.stage_steps;
  end_static_stage_in_equilibrium(report);
  report.time = s.clock.time();
  report.time_step = report.time - start;
  const SolveTimes& now = s.open_close.times();
  report.phases = {s.detect_seconds - detect_before, now.assemble - before.assemble, now.factor - before.factor,
                   now.solve - before.solve,         now.update - before.update,     0};
  s.outcomes.add_to(report, s.contacts);
  return report;
}

void Simulation::take_fixed_step(StepReport& report) {
  State& s = *state_;
  const double length = s.clock.next_length();
  double left = length;
  while (left > 1e-9 * length) {
    const double trial = std::min(left, s.trial_length);
    if (try_step(s.clock.time() + length - left, trial, report)) {
      accept(report);
      left -= trial;
      s.trial_length = std::min(trial * cut_factor, length);
    } else if (trial / cut_factor < shortest_share * length) {
      return;
    } else {
      failure_.clear();
      s.trial_length = trial / cut_factor;
      ++report.cuts;
    }
  }
  s.clock.advance();
}

void Simulation::take_adaptive_step(StepReport& report) {
  State& s = *state_;
  for (;;) {
    const double length = std::min(s.control.length(), s.clock.left());
    const int before = report.iterations;
    const bool settled = try_step(s.clock.time(), length, report);
    const StepMeasure measure = settled ? measure_step(report.iterations - before) : StepMeasure{};
    if (settled && s.control.acceptable(measure, length)) {
      accept(report);
      s.control.taken(measure, length);
      s.clock.advance_by(length);
      return;
    }
    if (!settled && !s.control.may_be_shorter(length)) return;
    failure_.clear();
    s.control.refused(measure, length);
    ++report.cuts;
  }
}

StepMeasure Simulation::measure_step(int iterations) const {
  const State& s = *state_;
  StepMeasure measure;
  measure.iterations = iterations;
  for (int n = 0; n < s.bodies.nodes.movable; ++n)
    measure.displacement = std::max(measure.displacement, s.increment.segment<3>(3 * n).norm());
  if (s.composition.inertia && s.context.dynamic_factor > 0)
    measure.time_error = s.composition.inertia->time_error(s.increment);
  return measure;
}

void Simulation::end_static_stage_in_equilibrium(StepReport& report) {
  State& s = *state_;
  if (!converged() || s.clock.stage_ended()) return;
  const Stage& stage = s.project.stages[s.clock.stage()];
  if (!stage.until_equilibrium || stage.kind != StageKind::static_ || s.stage_steps < fewest_static_steps) return;
  if (s.bodies.nodes.movable > 0 && s.open_close.imbalance() > stage.equilibrium_tolerance) return;
  report.equilibrium = true;
  s.clock.end_stage();
}

void Simulation::detect(double length) {
  State& s = *state_;
  const Stopwatch watch(s.detect_seconds);
  double prescribed = 0;
  for (const int b : s.bodies.driven)
    prescribed = std::max(prescribed, s.bodies.nodes.prescribed[s.bodies.bodies[b].first_node].norm());
  const double way = s.context.dynamic_factor * s.bodies.top_speed() * length + 0.5 * s.project.gravity.norm() * length * length;
  s.detector.detect(s.bodies.nodes.position, reach_factor * (way + prescribed) + reach_share * s.smallest_size,
                    s.contacts);
  s.links.connect();
  if (s.pattern_generation == s.detector.coupling_generation()) return;
  s.pattern_generation = s.detector.coupling_generation();
  std::vector<std::pair<int, int>> couplings;
  std::vector<int> freedoms, others;
  for (const auto& [i, j] : s.detector.coupled_nodes()) {
    s.bodies.freedoms_of(i, freedoms);
    s.bodies.freedoms_of(j, others);
    for (const int a : freedoms)
      for (const int b : others)
        if (a != b) couplings.emplace_back(a, b);
  }
  s.open_close.set_pattern(s.bodies.nodes.movable, std::move(couplings));
}

bool Simulation::inverts_an_element() const {
  const State& s = *state_;
  return std::any_of(s.bodies.elements.begin(), s.bodies.elements.end(), [&](const Element& element) {
    Corners corners = s.bodies.corner_increments(element, s.increment);
    for (int i = 0; i < 4; ++i) corners[i] += s.bodies.nodes.position[element.nodes[i]];
    return !(element_shape(corners).volume > 0);
  });
}

bool Simulation::settle(StepReport& report) {
  State& s = *state_;
  Settling result = s.open_close.settle(s.increment);
  report.iterations += result.iterations;
  for (int round = 0; result.settled && s.augmented() && round < augmentation_limit; ++round) {
    if (relative_penetration(s.links, s.increment) <= *s.project.solver.penetration_tolerance) break;
    raise_multipliers(s.contacts, s.links, s.increment);
    result = s.open_close.settle(s.increment);
    report.iterations += result.iterations;
  }
  report.unbalanced_force = result.residual;
  if (result.settled && !inverts_an_element()) return true;
  if (result.settled) {
    failure_ = "a tetrahedron turned inside out at t = " + std::to_string(time()) + " s";
    return false;
  }
  failure_ = "the open-close iteration did not settle at t = " + std::to_string(time()) + " s";
  failure_ += where_it_struggles(result.worst_node);
  return false;
}

std::string Simulation::where_it_struggles(int freedom) const {
  const State& s = *state_;
  if (freedom < 0 || s.contacts.points.empty()) return "";
  const Vec3 where_it_is = s.bodies.place_of(freedom);
  const auto distance = [&](const ContactPoint& point) {
    return (point.position - where_it_is).squaredNorm();
  };
  const ContactPoint& nearest =
      *std::min_element(s.contacts.points.begin(), s.contacts.points.end(),
                        [&](const ContactPoint& a, const ContactPoint& b) { return distance(a) < distance(b); });
  const auto coordinate = [&](int k) { return std::to_string(nearest.position[k]); };
  std::string where = ": contact " + s.system.blocks[nearest.bodies[0]].name + " - " +
                      s.system.blocks[nearest.bodies[1]].name + " at (" + coordinate(0) + ", " + coordinate(1) + ", " +
                      coordinate(2) + ") m";
  if (!s.project.joints.empty()) where += ", joint " + s.project.joints[nearest.joint].name;
  return where;
}

bool Simulation::try_step(double start, double length, StepReport& report) {
  State& s = *state_;
  failure_.clear();
  s.context.time = start;
  s.context.length = length;
  s.motion->begin_step(s.bodies, start + length);
  if (s.bodies.nodes.movable == 0) return true;
  detect(length);
  for (const auto& effect : s.composition.effects) effect->begin_step(s.context);
  s.open_close.begin_step(s.context);
  if (s.accelerations_wanted) {
    s.bodies.give_accelerations(s.open_close.start_accelerations(s.context));
    s.accelerations_wanted = false;
  }
  s.first_guess.choose(s.open_close, s.bodies, s.context, s.increment);
  return settle(report);
}

void Simulation::accept(StepReport& report) {
  State& s = *state_;
  if (s.bodies.nodes.movable > 0) {
    const StepMeasure measure = measure_step(0);
    report.max_displacement = std::max(report.max_displacement, measure.displacement);
    report.time_error = std::max(report.time_error, measure.time_error);
    s.outcomes.take(s.contacts, s.links, s.composition, s.increment, s.augmented());
    for (const auto& effect : s.composition.effects) effect->accept(s.increment);
    s.detector.accept(s.contacts, s.outcomes.outcomes());
  }
  s.bodies.move(s.increment);
  for (const auto* moved : {&s.bodies.moving, &s.bodies.driven})
    for (const int b : *moved)
      if (const double way = s.bodies.bodies[b].way; way > 0) s.detector.moved(b, way);
  s.bodies.carry_velocities();
  if (s.project.solver.strain == Strain::incremental) s.bodies.update_shapes();
  report.energy = s.energy.after_step(s.composition, s.open_close.works(), s.increment);
  s.first_guess.remember(s.increment, s.context.length);
}

std::vector<Voigt> Simulation::present_stress() const {
  const State& s = *state_;
  std::vector<Voigt> stress(s.bodies.elements.size(), Voigt::Zero());
  for (const auto& effect : s.composition.effects) effect->add_stress(stress);
  return stress;
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
    std::vector<Voigt> own = s.bodies.stress_of_held(static_cast<int>(b));
    if (!body.fixed)
      own.assign(stress.begin() + body.first_element, stress.begin() + body.first_element + body.element_count);
    own.resize(tetrahedra, body.kind == BodyKind::affine && !own.empty() ? own.front() : Voigt(Voigt::Zero()));
    frame.stress.insert(frame.stress.end(), own.begin(), own.end());
  }
  frame.contacts = contacts();
  return frame;
}

std::vector<ContactSample> Simulation::contacts() const { return state_->outcomes.samples(state_->contacts); }

HistoryRow Simulation::history() const {
  const State& s = *state_;
  HistoryRow row;
  row.time = time();
  row.stage = stage();
  for (const MaterialPoint& point : s.monitors)
    row.monitors.push_back(
        {point.at(s.bodies.nodes.position) - point.at(s.bodies.nodes.reference), point.at(s.bodies.nodes.velocity)});
  return row;
}

std::vector<EffectOutcome> Simulation::effects() const {
  const State& s = *state_;
  const std::map<std::string, double> seconds = s.open_close.effect_seconds();
  std::vector<EffectOutcome> outcomes;
  for (const EffectStatus& status : called_effects(s.project, s.system)) {
    const auto spent = seconds.find(status.name);
    outcomes.push_back({status.name, status.active, status.reason, spent == seconds.end() ? 0 : spent->second});
  }
  return outcomes;
}

}  // namespace talus
