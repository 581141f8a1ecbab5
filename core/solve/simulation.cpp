#include "solve/simulation.hpp"

#include <algorithm>

#include "solve/awake_bodies.hpp"
#include "solve/contact_search.hpp"
#include "solve/simulation_state.hpp"
#include "solve/stage_start.hpp"
#include "solve/step_checks.hpp"
#include "solve/step_corrections.hpp"

/// A time step from top to bottom. `Simulation::step` takes a fixed or an adaptive one; both try steps of some length
/// until one is good, and accept it. A trial detects contacts, sets the step up, guesses, converges and checks.
namespace talus {

namespace {

// In the order in which they come:
void take_fixed_step(SimulationState& s, StepReport& report);
void take_adaptive_step(SimulationState& s, StepReport& report);
bool try_step(SimulationState& s, double start, double length, StepReport& report);
void set_times(SimulationState& s, double start, double length);
void set_up(SimulationState& s);
void give_start_accelerations(SimulationState& s);
OpenCloseResult converge(SimulationState& s);
void follow_corrections(SimulationState& s);
OpenCloseResult converge_with_missed(SimulationState& s, std::span<const ContactDetector::MissedContact>& missed);
bool check(SimulationState& s, const OpenCloseResult& result, std::span<const ContactDetector::MissedContact> missed,
           StepReport& report);
bool retry_with_more_inertia(SimulationState& s, bool good);
bool retry_with_softer_springs(SimulationState& s, bool good);
void choose_springs(SimulationState& s, int iterations);
void cut(SimulationState& s, StepReport& report);
void accept(SimulationState& s, StepReport& report);
void remember_step(SimulationState& s, StepReport& report);
void move_bodies(SimulationState& s, StepReport& report);
void put_to_sleep(SimulationState& s);
void end_static_stage_in_equilibrium(SimulationState& s, StepReport& report);
StepMeasure measure(const SimulationState& s, int iterations);

}  // namespace

StepReport Simulation::step() {
  SimulationState& s = *state_;
  if (s.clock.stage_begins() && s.step > 0) begin_stage(s);
  StepReport report;
  report.step = ++s.step;
  report.stage = s.clock.stage();
  s.troubles.begin_step(s.step);
  const double start = s.clock.time();
  const SolveTimes before = s.open_close.times();
  const double detect_before = s.detect_seconds;
  if (s.adaptive())
    take_adaptive_step(s, report);
  else
    take_fixed_step(s, report);
  ++s.stage_steps;
  end_static_stage_in_equilibrium(s, report);
  report.time = s.clock.time();
  report.time_step = report.time - start;
  const SolveTimes now = s.open_close.times();
  report.phases = {s.detect_seconds - detect_before, now.assemble - before.assemble, now.factor - before.factor,
                   now.solve - before.solve,         now.update - before.update,     0};
  s.outcomes.add_to(report);
  report.asleep = s.sleep.count();
  s.block_steps_asleep += report.asleep;
  return report;
}

namespace {

/// The step of the stage, in parts that are shorter where need be.
void take_fixed_step(SimulationState& s, StepReport& report) {
  const StepTolerances& t = s.tolerances.step;
  const double length = s.clock.next_length();
  double left = length;
  while (left > t.time_rounding * length) {
    const double trial = std::min(left, s.trial_length);
    if (try_step(s, s.clock.time() + length - left, trial, report)) {
      accept(s, report);
      left -= trial;
      s.trial_length = std::min(trial * t.cut_factor, length);
    } else if (!s.goes_through && trial / t.cut_factor < shortest_part(s, length)) {
      s.troubles.note_end_of_run();
      return;
    } else {
      s.trial_length = trial / t.cut_factor;
      cut(s, report);
    }
  }
  s.clock.advance();
}

/// One step of the length that its control chooses.
void take_adaptive_step(SimulationState& s, StepReport& report) {
  for (;;) {
    const double length = std::min(s.control.length(), s.clock.left());
    const int before = report.iterations;
    const bool good = try_step(s, s.clock.time(), length, report);
    const StepMeasure measured = good ? measure(s, report.iterations - before) : StepMeasure{};
    if (good && s.control.acceptable(measured, length)) {
      accept(s, report);
      s.control.accept(measured, length);
      s.clock.advance_by(length);
      return;
    }
    if (!good && !s.goes_through && !s.control.may_be_shorter(length)) {
      s.troubles.note_end_of_run();
      return;
    }
    s.control.refuse(measured, length);
    if (good)
      ++report.cuts;
    else
      cut(s, report);
  }
}

/// Tries a step of `length` from `start` [s] without accepting it: finds its increment. Whether it may be accepted.
bool try_step(SimulationState& s, double start, double length, StepReport& report) {
  for (int rings = 2;;) {  // of sleepers that wake: those who are pressed, and whom they touch
    set_times(s, start, length);
    if (!s.anything_moves()) return true;
    detect_contacts(s, length);
    if (!s.anything_moves()) return true;  // the last ones have fallen asleep
    set_up(s);
    if (s.project.solver.open_close == OpenCloseMethod::states)
      s.increment.setZero();  // a linear system is solved from anywhere
    else
      s.first_guess.choose(s.open_close, s.bodies, s.context, s.increment);
    std::span<const ContactDetector::MissedContact> missed;
    const OpenCloseResult result = converge_with_missed(s, missed);
    if (wake_pressed(s, result.converged, missed, rings)) {
      report.iterations += result.iterations;
      rings *= 2;  // who is far from a blow is not to wait for all between
      continue;
    }
    const bool good = check(s, result, missed, report);
    if (good && s.company.goes_too_far(s.bodies, s.increment)) continue;
    if (!retry_with_more_inertia(s, good) && !retry_with_softer_springs(s, good)) return good;
  }
}

void set_times(SimulationState& s, double start, double length) {
  s.context.time = start;
  s.context.length = length;
  if (!s.dynamic()) s.context.integration.beta = s.integration.beta / s.pseudo_transient.inertia_fraction();
  s.motion->begin_step(s.bodies, start + length);
}

/// Of the stage [s].
double longest_step(const SimulationState& s) { return s.project.stages[s.clock.stage()].time_step; }

void set_up(SimulationState& s) {
  if (s.accelerations_wanted && s.may_fly())
    s.acceleration_reset.let_fly(s.bodies, s.contacts, s.tolerances.convergence.first_closing);
  if (s.resets_accelerations()) s.acceleration_reset.begin_step(s.bodies);
  s.reserve.begin_step(s.context);
  for (const auto& effect : s.composition.effects) effect->begin_step(s.context);
  s.open_close.begin_step(s.context);
  if (s.accelerations_wanted) give_start_accelerations(s);
}

/// Those that a stage begins with: what is driven has gone no way yet. Where the step takes it, it would stand in the
/// bodies beside it.
void give_start_accelerations(SimulationState& s) {
  s.motion->stand_still(s.bodies);
  s.links.connect(s.context.arms);
  s.bodies.give_accelerations(s.open_close.start_accelerations(s.context));
  s.motion->begin_step(s.bodies, s.context.time + s.context.length);
  s.links.connect(s.context.arms);
  s.reserve.give(s.context, longest_step(s));
  s.energy.accelerations_were_given(s.reserve.total());
  s.accelerations_wanted = false;
}

/// Converges as far as contacts can be judged, corrects what that shows to be wrong, and goes on so until nothing is,
/// to the tolerance of the step. Corrections that come to no end leave contacts deep; the step is too long for them.
OpenCloseResult converge(SimulationState& s) {
  OpenCloseResult result;
  // Multipliers converge no further than the rounds that they are taken from.
  const bool early = !s.multiplies() && s.project.solver.open_close == OpenCloseMethod::newton;
  const double loosely = early ? s.tolerances.step.corrected_residual : 0;
  double enough = loosely;
  for (int round = 0;; ++round) {
    const OpenCloseResult last = s.open_close.converge(s.increment, enough);
    result = {.converged = last.converged,
              .iterations = result.iterations + last.iterations,
              .residual = last.residual,
              .force_scale = last.force_scale,
              .worst_dof_block = std::max(result.worst_dof_block, last.worst_dof_block)};
    if (!result.converged) return result;
    const bool is_last = round == s.tolerances.step.correction_limit;
    if (is_last) ++s.correction_limits;
    const bool corrected = (!is_last || may_look_again(s)) && correct(s);
    if (corrected && early) follow_corrections(s);
    result.converged = !(is_last && corrected);
    if (!result.converged) return result;
    if (!corrected && enough == 0) return result;
    enough = corrected ? loosely : 0;
  }
}

/// Corrections concern few bodies. These converge by themselves, and are corrected again, before all do.
void follow_corrections(SimulationState& s) {
  for (int round = 0; round < s.tolerances.step.correction_limit; ++round)
    if (!s.open_close.balance_changed(s.increment) || !correct(s)) return;
}

/// Converges, and again with the contacts that where it leads shows to be missed. `missed`: those that are left.
OpenCloseResult converge_with_missed(SimulationState& s, std::span<const ContactDetector::MissedContact>& missed) {
  OpenCloseResult result = converge(s);
  for (int round = 0; result.converged; ++round) {
    missed = missed_contacts(s);
    if (missed.empty() || round == s.tolerances.step.correction_limit || !take_in(s, missed)) break;
    const int before = result.iterations;
    result = converge(s);
    result.iterations += before;
  }
  return result;
}

/// Whether the step has converged to something that may be accepted. Notes trouble.
bool check(SimulationState& s, const OpenCloseResult& result, std::span<const ContactDetector::MissedContact> missed,
           StepReport& report) {
  report.iterations += result.iterations;
  report.unbalanced_force = result.residual;
  const int node = result.worst_dof_block < 0 ? -1 : s.bodies.node_of(result.worst_dof_block);
  s.goes_through = false;
  const auto note = [&](TroubleCause cause, int at) { s.troubles.note(cause, at, s.context, result.iterations); };
  if (!result.converged) {
    note(TroubleCause::not_converged, node);
    return false;
  }
  if (const int element = inverted_element(s); element >= 0) {
    note(TroubleCause::inverted, s.bodies.elements[element].nodes[0]);
    return false;
  }
  if (!missed.empty()) {
    const ContactDetector::MissedContact& deepest = missed.front();
    s.troubles.note_missed_contact(deepest.bodies, deepest.position, deepest.depth, s.context, result.iterations);
    return false;
  }
  const std::optional<DeepPair> pair = passage(s);
  s.goes_through = pair.has_value();
  if (pair) {
    s.troubles.note_missed_contact(pair->bodies, pair->position, pair->depth / pair->size, s.context,
                                   result.iterations);
    return false;
  }
  if (node >= 0) note(TroubleCause::many_iterations, node);
  return true;
}

/// Whether a static step kept too little inertia and is to be tried again.
bool retry_with_more_inertia(SimulationState& s, bool good) {
  if (s.dynamic()) return false;
  const double displacement = measure(s, 0).displacement;
  if (!s.pseudo_transient.needs_retry(good, displacement)) return false;
  s.pseudo_transient.restore_inertia(good, displacement);
  return true;
}

/// Whether a static step is to be tried again with springs that it can follow.
bool retry_with_softer_springs(SimulationState& s, bool good) {
  if (good || s.followed_contacts != FollowedContacts::none || !s.is_on(EffectKind::followed_springs)) return false;
  s.followed_contacts = FollowedContacts::all;
  return true;
}

/// In a static stage contacts are as stiff as rock, until a step has been hard: then springs are such as steps can
/// follow.
void choose_springs(SimulationState& s, int iterations) {
  if (s.followed_contacts == FollowedContacts::all) s.followed_contacts = FollowedContacts::new_ones;
  const bool hard = iterations > s.tolerances.convergence.hard_step;
  if (hard && s.followed_contacts == FollowedContacts::none) s.followed_contacts = FollowedContacts::all;
}

void cut(SimulationState& s, StepReport& report) {
  ++report.cuts;
  s.troubles.note_cut();
}

void accept(SimulationState& s, StepReport& report) {
  choose_springs(s, report.iterations);
  const bool may_hit = s.impacts && s.dynamic() && s.anything_moves();
  if (may_hit) s.impacts->note_speeds(s.contacts, s.context);
  s.outcomes.take(s.contacts, s.links, s.composition, s.increment, s.augmented());
  const bool may_fly = s.may_fly();
  if (may_fly) {
    const EffectTimer timer(s.work_of(EffectKind::acceleration_reset));
    s.free_flight.note_start(s.contacts, s.outcomes.outcomes());
  }
  const double let_go = may_hit ? s.impacts->let_go_landed(s.contacts, s.context, s.outcomes.outcomes()) : 0;
  if (s.anything_moves()) remember_step(s, report);
  move_bodies(s, report);
  ImpactEnergy by_impacts =
      may_hit ? s.impacts->apply(s.contacts, s.context, s.outcomes.outcomes(), s.reserve) : ImpactEnergy{};
  by_impacts.taken += let_go;
  if (s.anything_moves() && s.resets_accelerations()) {
    const EffectTimer timer(s.work_of(EffectKind::acceleration_reset));
    if (may_fly) s.free_flight.end_step(s.reserve);
    s.acceleration_reset.end_step(s.bodies, s.context.length, s.free_flight);
  }
  if (s.project.solver.strain == Strain::incremental) s.bodies.update_shapes();
  if (s.dynamic() && s.is_on(EffectKind::sleep)) put_to_sleep(s);
  report.energy = s.anything_moves()
                      ? s.energy.after_step(s.composition, s.open_close.residual().works(), s.increment, by_impacts,
                                            s.detector.spring_energy_at_rest(), s.reserve.total())
                      : s.energy.ledger();
  s.first_guess.remember(s.increment, s.context.length);
}

/// What effects, contacts and accelerations remember of the step; the bodies have not moved yet.
void remember_step(SimulationState& s, StepReport& report) {
  const StepMeasure measured = measure(s, 0);
  report.time_error = std::max(report.time_error, measured.time_error);
  if (!s.dynamic() && s.project.solver.static_inertia == StaticInertia::fading)
    s.pseudo_transient.accept(measured.displacement, s.open_close.residual().static_residual());
  s.acceleration_reset.note_start(s.bodies, s.contacts, s.outcomes.outcomes());
  s.reserve.note_start(s.context);
  for (const auto& effect : s.composition.effects) effect->accept(s.increment);
  if (s.resets_accelerations()) s.acceleration_reset.drop(s.bodies, s.free_flight);
  s.reserve.hold(s.context, longest_step(s));
  s.detector.accept(s.contacts, s.outcomes.outcomes());
}

void move_bodies(SimulationState& s, StepReport& report) {
  s.bodies.move(s.increment);
  for (const int b : s.bodies.moving)
    report.max_displacement = std::max(report.max_displacement, s.bodies.bodies[b].largest_displacement);
  for (const auto* moved : {&s.bodies.moving, &s.bodies.driven})
    for (const int b : *moved)
      if (const double displacement = s.bodies.bodies[b].largest_displacement; displacement > 0) {
        s.company.moved(b, displacement);
        if (!s.company.is_alone(b)) s.detector.moved(b, displacement);
      }
  s.company.step_taken();
  s.bodies.carry_velocities();
}

void put_to_sleep(SimulationState& s) {
  const EffectTimer timer(s.work_of(EffectKind::sleep));
  const std::vector<int>& sleepers = s.sleep.after_step(s.bodies, s.contacts, s.context.length);
  s.sleepers_change = !sleepers.empty();
  if (s.sleepers_change) s.sleeper_loads.fall_asleep(sleepers, s.bodies, s.contacts, s.outcomes.outcomes());
}

void end_static_stage_in_equilibrium(SimulationState& s, StepReport& report) {
  if (s.troubles.run_ended() || s.clock.stage_ended()) return;
  const Stage& stage = s.project.stages[s.clock.stage()];
  if (!stage.until_equilibrium || s.dynamic() || s.stage_steps < s.tolerances.step.fewest_static_steps) return;
  if (s.anything_moves()) report.out_of_balance = s.open_close.residual().static_residual();
  if (report.out_of_balance > stage.equilibrium_tolerance) return;
  report.equilibrium = true;
  s.clock.end_stage();
}

StepMeasure measure(const SimulationState& s, int iterations) {
  StepMeasure measured;
  measured.iterations = iterations;
  for (int n = 0; n < s.bodies.nodes.movable; ++n)
    measured.displacement = std::max(measured.displacement, s.increment.segment<3>(3 * n).norm());
  if (s.composition.inertia && s.dynamic()) measured.time_error = s.composition.inertia->time_error(s.increment);
  return measured;
}

}  // namespace

}  // namespace talus
