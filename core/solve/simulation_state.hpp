#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/stopwatch.hpp"
#include "contact/detection/contact_detector.hpp"
#include "contact/detection/missed_contacts.hpp"
#include "contact/detection/normal_update.hpp"
#include "contact/passage/passage.hpp"
#include "mesh/surface.hpp"
#include "model/tolerances.hpp"
#include "solve/company.hpp"
#include "solve/contact_outcomes.hpp"
#include "solve/dynamics/acceleration_reset.hpp"
#include "solve/dynamics/followed_springs.hpp"
#include "solve/dynamics/free_flight.hpp"
#include "solve/dynamics/impacts.hpp"
#include "solve/dynamics/integration_reserve.hpp"
#include "solve/dynamics/prescribed_motion.hpp"
#include "solve/dynamics/pseudo_transient.hpp"
#include "solve/dynamics/sleep.hpp"
#include "solve/dynamics/sleeper_loads.hpp"
#include "solve/dynamics/stage_clock.hpp"
#include "solve/dynamics/step_control.hpp"
#include "solve/energy_balance.hpp"
#include "solve/equilibrium/first_guess.hpp"
#include "solve/equilibrium/open_close.hpp"
#include "solve/local_origin.hpp"
#include "solve/penalty_scaling.hpp"
#include "solve/stress_recovery.hpp"
#include "solve/trouble_log.hpp"

namespace talus {

/// Times and counts, as long as it lives, the work of an effect that is no term of the potential.
class EffectTimer {
 public:
  explicit EffectTimer(StepResidual::EffectWork& work) : watch_(work.seconds) { ++work.evaluations; }

 private:
  Stopwatch watch_;
};

/// What a simulation is made of, and where it stands. Only the files that carry out its steps see it.
struct SimulationState {
  SimulationState(const Project& project, const BlockSystem& system, const Tolerances& tolerances);

  bool adaptive() const { return project.solver.time_step_control == TimeStepControl::adaptive; }
  bool augmented() const { return project.solver.penetration_tolerance.has_value(); }
  /// Whether multipliers keep contacts from sinking too deep, in place of stiffer springs. They push out what is in
  /// already, at once: in a moving block that would be speed from nothing.
  bool multiplies() const { return augmented() && !dynamic(); }
  /// Whether an effect is on, as far as blocks can touch.
  bool is_on(EffectKind kind) const { return called[static_cast<std::size_t>(kind)].active; }
  bool dynamic() const { return context.dynamic_factor > 0; }  ///< is the stage?
  bool resets_accelerations() const {
    return is_on(EffectKind::acceleration_reset) && dynamic() && context.integration.carries_acceleration();
  }
  /// Whether bodies may be found to fly freely.
  bool may_fly() const { return resets_accelerations() && anything_moves() && FreeFlight::is_possible(composition); }
  /// The composition may have come to call for the law of impact.
  void expect_impacts() {
    if (composition.rebounds && !impacts) impacts.emplace(bodies, tolerances.impact);
  }
  StepResidual::EffectWork& work_of(EffectKind kind) { return extra_work[static_cast<std::size_t>(kind)]; }
  double penetration() const;  ///< of h, that contacts may have
  bool anything_moves() const { return bodies.nodes.movable > 0; }

  const LocalModel model;
  const Project& project;  ///< about the local origin, as all that follows
  const BlockSystem& system;
  const SolverTolerances tolerances;
  const std::vector<EffectStatus> called;  ///< if all blocks could touch

  // Bodies and their contacts.
  BodySet bodies;
  std::vector<Surface> surfaces;
  double smallest_size;  ///< m, mesh size of blocks that may move
  ContactDetector detector;
  ContactSet contacts;
  ContactLinks links{bodies, contacts};
  ContactOutcomes outcomes;
  PenaltyScaling penalty_scaling;
  Company company;
  std::vector<RestingContact> resting;       ///< contacts of sleepers
  std::uint64_t pattern_generation = ~0ull;  ///< of the contacts that the equations' pattern was made for

  // The stage.
  StageClock clock;
  std::vector<bool> held;       ///< bodies that the stage holds
  TimeIntegration integration;  ///< of the stage
  Composition composition;      ///< its effects
  std::optional<PrescribedMotion> motion;
  bool velocities_given = false;  ///< the initial ones, with the first dynamic stage
  int stage_steps = 0;

  // A step: its stages in the order of simulation.cpp.
  StepControl control;
  double trial_length = 1e300;  ///< s, what the next fixed step is tried with
  StepContext context;          ///< of the step that is tried
  Reach reach;                  ///< up to which gaps matter in it
  Increment increment;
  OpenClose open_close;
  FirstGuess first_guess;
  PseudoTransientContinuation pseudo_transient;  ///< of static stages
  AccelerationReset acceleration_reset;
  IntegrationReserve reserve;
  FreeFlight free_flight{bodies};
  std::vector<Vec3> foreseen;  ///< m, where nodes will be later in the step
  NormalUpdate normal_update;
  MissedContacts missed_contacts{bodies};
  std::optional<PassageCheck> passage;  ///< none where missed contacts are not looked for
  bool goes_through = false;  ///< the trial step took a body through another: it is cut until no body goes that far
  FollowedSprings followed_springs;
  FollowedContacts followed_contacts = FollowedContacts::none;
  std::optional<Impacts> impacts;  ///< where some joint takes speed from them
  Sleep sleep;
  SleeperLoads sleeper_loads;
  bool accelerations_wanted = false;  ///< the next step is to begin with those of OpenClose
  bool sleepers_change = false;       ///< bodies fall asleep or wake, before contacts are sought again

  // What is told of it.
  EnergyBalance energy;
  StressRecovery stress;
  TroubleLog troubles;
  std::vector<MaterialPoint> monitors;
  int step = 0;
  double detect_seconds = 0;
  std::array<StepResidual::EffectWork, effect_kinds> extra_work{};  ///< of effects that are no term of the potential
  long block_steps_asleep = 0;
  long correction_limits = 0;  ///< steps that used all their rounds of correction
};

}  // namespace talus
