#include "solve/simulation.hpp"

#include <algorithm>
#include <cmath>

#include "solve/simulation_state.hpp"
#include "solve/stopwatch.hpp"
#include "solve/turning_contacts.hpp"

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
/// Of the mesh size: in dynamic stages contacts whose stiffness nobody has given go no deeper.
constexpr double usual_tolerance = 5e-4;
/// Of the stage's step: one that is shorter is taken though blocks turn into each other in it.
constexpr double long_enough = 0.03;
/// A static stage is in equilibrium no sooner than after this many steps.
constexpr int fewest_static_steps = 2;

}  // namespace

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

StepReport Simulation::step() {
  State& s = *state_;
  if (s.clock.stage_begins() && s.step > 0) begin_stage();
  StepReport report;
  struggles_.clear();
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
  s.outcomes.add_to(report);
  report.asleep = s.sleep.count();
  s.block_steps_asleep += report.asleep;
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
      return give_up();
    } else {
      s.trial_length = trial / cut_factor;
      note_cut(report);
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
    if (!settled && !s.control.may_be_shorter(length)) return give_up();
    s.control.refused(measure, length);
    if (settled)
      ++report.cuts;
    else
      note_cut(report);
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
  if (s.bodies.nodes.movable > 0 && s.open_close.balance().imbalance() > stage.equilibrium_tolerance) return;
  report.equilibrium = true;
  s.clock.end_stage();
}

void Simulation::seek_contacts(double length) {
  State& s = *state_;
  double prescribed = 0;
  for (const int b : s.bodies.driven)
    prescribed = std::max(prescribed, s.bodies.nodes.prescribed[s.bodies.bodies[b].first_node].norm());
  const double way =
      s.context.dynamic_factor * s.bodies.top_speed() * length + 0.5 * s.project.gravity.norm() * length * length;
  const double reach = reach_factor * (way + prescribed);
  s.context.reach = reach + s.smallest_size;
  s.reach = reach + reach_share * s.smallest_size;
  s.detector.detect(s.bodies.nodes.position, s.reach, s.contacts);
  s.links.connect();
}

void Simulation::detect(double length) {
  State& s = *state_;
  const Stopwatch watch(s.detect_seconds);
  const bool fell_asleep = s.falls_asleep;
  if (fell_asleep) let_sleep_and_wake();
  seek_contacts(length);
  bool changed = fell_asleep;
  while (s.sleep.wake_touched(s.bodies, s.contacts)) {  // what wakes may touch what sleeps
    let_sleep_and_wake();
    seek_contacts(length);
    changed = true;
  }
  if (changed) account_for_the_awake();
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

const ContactSet& Simulation::look_for_contacts() {
  State& s = *state_;
  if (s.bodies.nodes.movable > 0) seek_contacts(s.adaptive() ? s.control.length() : s.clock.next_length());
  return s.contacts;
}

int Simulation::inverted_element() const {
  const State& s = *state_;
  const auto found = std::find_if(s.bodies.elements.begin(), s.bodies.elements.end(), [&](const Element& element) {
    Corners corners = s.bodies.corner_increments(element, s.increment);
    for (int i = 0; i < 4; ++i) corners[i] += s.bodies.nodes.position[element.nodes[i]];
    return !(element_shape(corners).volume > 0);
  });
  return found == s.bodies.elements.end() ? -1 : static_cast<int>(found - s.bodies.elements.begin());
}

bool Simulation::settle(StepReport& report) {
  State& s = *state_;
  Settling result = s.open_close.settle(s.increment);
  int iterations = result.iterations, hard = result.worst_freedom;
  const auto to_be_taken_anew = [&] {
    const bool blows = s.context.dynamic_factor > 0 && s.context.integration.holds_on_to_blows();
    return press_apart() || (blows && s.shocks.slacken(s.bodies, s.context, s.increment));
  };
  for (int round = 0; result.settled && round < augmentation_limit && to_be_taken_anew(); ++round) {
    result = s.open_close.settle(s.increment);
    iterations += result.iterations;
    hard = std::max(hard, result.worst_freedom);
  }
  report.iterations += iterations;
  report.unbalanced_force = result.residual;
  const int node = hard < 0 ? -1 : s.bodies.node_of(hard);
  const int inverted = result.settled ? inverted_element() : -1;
  if (!result.settled)
    note_struggle(StruggleCause::not_settled, node, iterations);
  else if (inverted >= 0)
    note_struggle(StruggleCause::inverted, s.bodies.elements[inverted].nodes[0], iterations);
  else if (find_late_contact(iterations))
    return false;
  else if (node >= 0)
    note_struggle(StruggleCause::many_iterations, node, iterations);
  return result.settled && inverted < 0;
}

bool Simulation::find_late_contact(int iterations) {
  State& s = *state_;
  const double longest = s.project.stages[s.clock.stage()].time_step;
  if (s.context.dynamic_factor == 0 || s.context.length < long_enough * longest) return false;
  const double tolerance = s.project.solver.penetration_tolerance.value_or(usual_tolerance);
  const Stopwatch watch(s.detect_seconds);
  const auto late =
      s.late_contacts.seek(s.detector, s.links, s.increment, s.reach, tolerance, tolerance * s.smallest_size);
  if (late) note_late_contact(*late, iterations);
  return late.has_value();
}

bool Simulation::press_apart() {
  State& s = *state_;
  const std::optional<double>& asked = s.project.solver.penetration_tolerance;
  // Multipliers push out what is in already, at once: in a moving block that would be speed from nothing.
  if (s.context.dynamic_factor > 0) {
    const double tolerance = asked.value_or(usual_tolerance);
    const auto start = [&](int node) { return s.bodies.nodes.position[node]; };
    const auto end = [&](int node) { return Vec3(start(node) + s.bodies.node_increment(node, s.increment)); };
    const auto turned = [&](int point) { return s.detector.turned(point, start, end); };
    return follow_turning(s.contacts, s.links, turned, s.increment, tolerance) ||
           harden(s.contacts, s.links, s.increment, tolerance, asked ? std::span<const Joint>() : s.project.joints);
  }
  if (!asked || multiplier_error(s.links, s.increment) <= *asked) return false;
  adapt_multipliers(s.contacts, s.links, s.increment);
  return true;
}

bool Simulation::try_step(double start, double length, StepReport& report) {
  State& s = *state_;
  s.context.time = start;
  s.context.length = length;
  if (s.context.dynamic_factor == 0) s.context.integration.beta = s.integration.beta / s.fading.share();
  s.motion->begin_step(s.bodies, start + length);
  if (s.bodies.nodes.movable == 0) return true;
  detect(length);
  if (s.bodies.nodes.movable == 0) return true;
  for (const auto& effect : s.composition.effects) effect->begin_step(s.context);
  s.open_close.begin_step(s.context);
  if (s.accelerations_wanted) {
    s.bodies.give_accelerations(s.open_close.start_accelerations(s.context));
    s.accelerations_wanted = false;
  }
  s.first_guess.choose(s.open_close, s.bodies, s.context, s.increment);
  const bool settled = settle(report);
  if (s.context.dynamic_factor > 0) return settled;
  const double way = measure_step(0).displacement;
  if (!s.fading.led_astray(settled, way)) return settled;
  s.fading.restore(settled, way);
  return try_step(start, length, report);
}

void Simulation::accept(StepReport& report) {
  State& s = *state_;
  const bool may_hit = s.impacts && s.context.dynamic_factor > 0 && s.bodies.nodes.movable > 0;
  if (may_hit) s.impacts->note_speeds(s.contacts, s.context);
  s.outcomes.take(s.contacts, s.links, s.composition, s.increment, s.augmented());
  if (s.bodies.nodes.movable > 0) {
    const StepMeasure measure = measure_step(0);
    report.time_error = std::max(report.time_error, measure.time_error);
    if (s.context.dynamic_factor == 0) s.fading.taken(measure.displacement, s.open_close.balance().imbalance());
    for (const auto& effect : s.composition.effects) effect->accept(s.increment);
    s.detector.accept(s.contacts, s.outcomes.outcomes());
    s.shocks.look(s.bodies, s.contacts, s.outcomes.outcomes());
    if (s.context.dynamic_factor > 0 && s.context.integration.holds_on_to_blows()) s.shocks.forget(s.bodies);
  }
  s.bodies.move(s.increment);
  for (const int b : s.bodies.moving)
    report.max_displacement = std::max(report.max_displacement, s.bodies.bodies[b].way);
  for (const auto* moved : {&s.bodies.moving, &s.bodies.driven})
    for (const int b : *moved)
      if (const double way = s.bodies.bodies[b].way; way > 0) s.detector.moved(b, way);
  s.bodies.carry_velocities();
  const double by_impacts = may_hit ? s.impacts->take(s.contacts, s.context, s.outcomes.outcomes()) : 0;
  if (s.project.solver.strain == Strain::incremental) s.bodies.update_shapes();
  if (s.context.dynamic_factor > 0) s.falls_asleep = s.sleep.settle(s.bodies, s.contacts, s.context.length);
  report.energy = s.bodies.nodes.movable > 0
                      ? s.energy.after_step(s.composition, s.open_close.balance().works(), s.increment, by_impacts)
                      : s.energy.ledger();
  s.first_guess.remember(s.increment, s.context.length);
}

}  // namespace talus
