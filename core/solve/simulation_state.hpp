#pragma once

#include <optional>

#include "contact/contact_detector.hpp"
#include "solve/contact_outcomes.hpp"
#include "solve/energy_balance.hpp"
#include "solve/fading_inertia.hpp"
#include "solve/first_guess.hpp"
#include "solve/impacts.hpp"
#include "solve/late_contacts.hpp"
#include "solve/open_close.hpp"
#include "solve/prescribed_motion.hpp"
#include "solve/shocks.hpp"
#include "solve/simulation.hpp"
#include "solve/sleep.hpp"
#include "solve/stage_clock.hpp"

namespace talus {

/// What a simulation is made of. Only the files of Simulation see it.
struct Simulation::State {
  State(const Project& p, const BlockSystem& s);

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
  std::optional<Impacts> impacts;  ///< where some joint takes speed from them
  FirstGuess first_guess;
  StepControl control;
  FadingInertia fading;  ///< of static stages
  Shocks shocks{bodies};
  LateContacts late_contacts{bodies};
  Sleep sleep;
  std::vector<RestingContact> resting;  ///< contacts of sleepers
  EnergyBalance energy;
  std::optional<PrescribedMotion> motion;
  std::vector<MaterialPoint> monitors;
  std::vector<bool> held;
  TimeIntegration integration;  ///< of the stage
  StepContext context;          ///< of the step that is tried
  Increment increment;
  double trial_length = 1e300;  ///< s, what the next step is tried with
  std::uint64_t pattern_generation = ~0ull;
  bool velocities_given = false, accelerations_wanted = false, falls_asleep = false;
  double detect_seconds = 0;
  double reach = 0;  ///< m, up to which gaps matter in the step that is tried
  int step = 0, stage_steps = 0;
  long block_steps_asleep = 0;
  mutable long stress_recoveries = 0;  ///< looking at stress is counted, and changes nothing
};

}  // namespace talus
