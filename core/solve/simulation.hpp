#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bodies/block_motion.hpp"
#include "contact/contact_point.hpp"
#include "model/tolerances.hpp"
#include "results/convergence_trouble.hpp"
#include "results/frame.hpp"
#include "results/run_report.hpp"

namespace talus {

class StateArchive;
struct SimulationState;

/// A scene in motion. One call of `step` takes one step of the stage; nothing is written.
class Simulation {
 public:
  /// `project` and `system` outlive the simulation. Throws InputError for points outside their blocks.
  Simulation(const Project& project, const BlockSystem& system, const Tolerances& tolerances = {});
  ~Simulation();

  bool finished() const;     ///< all stages are done, or the last step did not converge
  bool stage_ended() const;  ///< the last step was the last of its stage
  bool stage_ends() const;   ///< the next step will be, by the time of the stage
  bool converged() const;    ///< the last step did
  /// What went wrong in the last step, when, where and what to change; empty where the run has converged.
  std::string failure() const;
  /// The hard trial steps of the last step: each that was cut, and each that converged slowly. Mostly none.
  const std::vector<ConvergenceTrouble>& troubles() const;
  int stage() const;        ///< index into Project::stages, of the last step
  double time() const;      ///< s
  double end_time() const;  ///< s
  long total_steps() const;

  /// One step: of the stage's length, in shorter parts where the open–close iteration does not converge; or as long as
  /// adaptive control chooses.
  StepReport step();

  /// Is called with each open–close iteration of a step and told the force that is out of balance [N].
  void watch_iterations(std::function<void(double unbalanced)> each_iteration);

  /// Contact points within reach of the next step, as that step would find them; takes none. They hold until the next
  /// call. With every block fixed there are none.
  const ContactSet& look_for_contacts();

  /// Writes down where it stands between two steps; or goes on from where another one of the same project and blocks
  /// stood, with the same bits. Throws std::runtime_error where what it reads is too short.
  void archive(StateArchive& state);

  Frame frame(int index) const;
  /// The frame of now but for what takes long, stresses, and what is not its own, number and classes of motion: these
  /// are those of an earlier one.
  Frame moment(const Frame& earlier) const;
  HistoryRow history() const;
  std::vector<ContactSample> contacts() const;  ///< of the last step, those of sleeping blocks too
  /// Of the last step, of blocks that are awake; about the local origin, as the bodies are.
  const std::vector<ContactSample>& awake_contacts() const;
  const BodySet& bodies() const;
  const Vec3& origin() const;  ///< m: the local origin, from which bodies are counted
  std::vector<EffectOutcome> effects() const;
  RunWork work() const;

 private:
  std::unique_ptr<SimulationState> state_;
};

}  // namespace talus
