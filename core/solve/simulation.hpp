#pragma once

#include <memory>
#include <string>

#include "bodies/block_motion.hpp"
#include "contact/contact_detector.hpp"
#include "contact/contact_point.hpp"
#include "mesh/block.hpp"
#include "results/frame.hpp"
#include "results/run_report.hpp"
#include "results/struggle.hpp"
#include "solve/step_control.hpp"

namespace talus {

/// A scene in motion. One call of `step` takes one step of the stage; nothing is written.
class Simulation {
 public:
  /// `project` and `system` outlive the simulation. Throws InputError for points outside their blocks.
  Simulation(const Project& project, const BlockSystem& system);
  ~Simulation();

  bool finished() const;     ///< all stages are done, or the last step did not converge
  bool stage_ended() const;  ///< the last step was the last of its stage
  bool converged() const { return struggles_.empty() || !struggles_.back().ended_run; }
  /// What went wrong in the last step, when, where and what to change; empty where the run has converged.
  std::string failure() const { return converged() ? "" : failure_text(struggles_.back()); }
  /// The hard trial steps of the last step: each that was cut, and each that settled slowly. Mostly none.
  const std::vector<Struggle>& struggles() const { return struggles_; }
  int stage() const;        ///< index into Project::stages, of the last step
  double time() const;      ///< s
  double end_time() const;  ///< s
  long total_steps() const;

  /// One step: of the stage's length, cut into shorter ones where the open–close iteration does not settle; or as long
  /// as adaptive control chooses.
  StepReport step();

  /// Contact points within reach of the next step, as that step would find them; takes none. They hold until the next
  /// call. With every block fixed there are none.
  const ContactSet& look_for_contacts();

  Frame frame(int index) const;
  HistoryRow history() const;
  std::vector<ContactSample> contacts() const;               ///< of the last step, those of sleeping blocks too
  const std::vector<ContactSample>& awake_contacts() const;  ///< of the last step, of blocks that are awake
  const BodySet& bodies() const;
  std::vector<EffectOutcome> effects() const;
  RunWork work() const;

 private:
  struct State;
  void begin_stage();
  void hold_blocks(int stage);
  void take_fixed_step(StepReport& report);
  void take_adaptive_step(StepReport& report);
  StepMeasure measure_step(int iterations) const;
  void end_static_stage_in_equilibrium(StepReport& report);
  /// Tries a step of `length` from `start` [s] without taking it.
  bool try_step(double start, double length, StepReport& report);
  bool settle(StepReport& report);
  /// Lets contacts that go deeper than the tolerance bear more; false where none does.
  bool press_apart();
  /// Blocks turn into each other in this step where it knows no contact, and a shorter one may still be tried.
  bool find_late_contact(int iterations);
  Struggle& note_struggle(StruggleCause cause, int node, int iterations);
  void note_late_contact(const ContactDetector::Late& late, int iterations);
  /// Blocks, joint and position: of the contact of the node's body that is nearest to the node, else of the node.
  void place_struggle(int node, Struggle& struggle) const;
  /// Where a place at a body lay before the run: it goes with the body's nearest node [m].
  Vec3 rest_of(const Vec3& place, int body) const;
  /// The trial step that failed was the last: none shorter is allowed.
  void give_up() { struggles_.back().ended_run = true; }
  void note_cut(StepReport& report);
  void seek_contacts(double length);
  void detect(double length);
  /// Holds the bodies that the stage holds or that sleep.
  void keep_still();
  void let_sleep_and_wake();
  /// Contacts have been sought for those that are awake now: what they hold is what the energy ledger goes on with.
  void account_for_the_awake();
  /// The first element that the increment turns inside out; −1: none.
  int inverted_element() const;
  void accept(StepReport& report);
  std::vector<Voigt> present_stress() const;
  /// Of a body's own elements, from those of all that move.
  std::vector<Voigt> stress_of(int body, const std::vector<Voigt>& stress) const;
  Voigt stress_at(const MaterialPoint& point, const std::vector<Voigt>& stress) const;
  std::unique_ptr<State> state_;
  std::vector<Struggle> struggles_;
};

}  // namespace talus
