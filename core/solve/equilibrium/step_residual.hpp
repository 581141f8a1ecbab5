#pragma once

#include <map>
#include <utility>
#include <vector>

#include "effects/compose.hpp"
#include "effects/contact_pass.hpp"
#include "model/solver_tolerances.hpp"
#include "solve/equilibrium/solve_times.hpp"

namespace talus {

/// The residual of a step: the gradient ∇Π(D) of all effects of a stage together at an increment D, and its
/// derivatives. The step has converged where it vanishes. Counts and times what each effect costs. The bodies and
/// contacts stand at the start of the step.
class StepResidual {
 public:
  /// Friction strengths: those of the D that is evaluated, or those at which they were frozen.
  enum class Friction { coupled, frozen };

  explicit StepResidual(const ConvergenceTolerances& tolerances = {}) : tolerances_(tolerances) {}

  /// The effects of a stage; they must live until end_stage.
  void begin_stage(Composition& composition);
  void end_stage();
  /// Effects were put into the composition of the stage; a pattern is to be set.
  void put_in(const PutIn& where);
  /// The couplings of contacts have changed.
  void set_pattern(int dof_blocks, std::vector<std::pair<int, int>> contact_couplings);
  /// One that was set before, couplings of effects and contacts.
  void set_pattern(const BlockPattern& pattern);
  /// Assembles what is constant through a step, where it has changed; called once after Effect::begin_step. Whether
  /// length or integration differ from those of the step before: then an old factor is no good preconditioner.
  bool begin_step(const StepContext& step);

  /// Finds the gradient at D, and the scale of the forces in it.
  void evaluate(const Increment& d, Friction friction);
  const Eigen::VectorXd& gradient() const { return gradient_; }  ///< N, at the last D that was evaluated
  double norm() const { return gradient_.norm(); }               ///< N
  Arms arms() const { return step_.arms; }                       ///< of coupled forces in this step
  /// Freezes at D, where the gradient is known, what has no potential: friction strengths, and what mean arms change in
  /// moments.
  void freeze(const Increment& d);
  /// The gradient at D = 0 without inertia's force.
  void evaluate_without_inertia();
  double force_scale() const { return force_scale_; }  ///< N, of the forces that the last gradient is the sum of
  /// Bodies that are coupled to no others balance apart from them: the independent systems, in the order of
  /// BlockPattern::connected_parts. A far or heavy body changes nothing of what is measured of another system.
  int systems() const { return static_cast<int>(systems_.size()); }
  int system_of(int dof_block) const { return system_of_[dof_block]; }
  double norm_of_system(int system) const { return systems_[system].norm; }          ///< N, of the last gradient
  double force_scale_of_system(int system) const { return systems_[system].scale; }  ///< N, as force_scale
  /// Whether on each body of a system no more than this fraction of the forces on it is out of balance.
  bool each_body_within(int system, double fraction) const;
  /// Whether on each so much is out of balance at most, a grain beside a mountain being no rounding, and what is left
  /// does next to no work, which the ledger would add up.
  bool each_body_balances(int system, double tolerance) const;
  /// Of the bodies that are looked at, those with more than `fraction` of the forces on them out of balance, by their
  /// places in BodySet::moving.
  void list_unbalanced(double fraction, std::vector<int>& bodies) const;
  /// From the next D on all forces but those on these bodies are left out, and effects look at them alone. Null: all
  /// count again.
  void look_at(const PickedBodies* picked);
  /// The degree-of-freedom blocks of a place in BodySet::moving: the first, and the one behind the last.
  std::pair<int, int> dof_blocks_of(int body) const { return {body_begins_[body], body_begins_[body + 1]}; }
  int bodies() const { return static_cast<int>(body_begins_.size()) - 1; }
  int bodies_looked_at() const { return picked_ ? static_cast<int>(picked_->places.size()) : bodies(); }
  double norm_of_body(int body) const { return norm_of_body(gradient_, body); }  ///< N, of the last gradient
  /// ∇Π_e·D of each effect at the last D that was evaluated [J].
  const std::vector<double>& works() const { return works_; }
  /// Norm of inertia's force over that of the largest other force, at the last D: the relative residual of static
  /// equilibrium.
  double static_residual() const;

  /// Assembles the Hessian at D, and with coupled friction the unsymmetric part of the derivative of the gradient;
  /// that is zero with frozen one. Contacts that are open by less than `touching`, of the mesh size, count as closed.
  void assemble(const Increment& d, double touching, Friction friction);
  const SymmetricBlocks& matrix() const { return matrix_; }              ///< N/m, as last assembled
  const UnsymmetricBlocks& unsymmetric() const { return unsymmetric_; }  ///< N/m, as last assembled
  /// Estimates from that matrix how large a residual the rounding of deformations, and of positions at the start of the
  /// step, may leave.
  void measure_rounding();
  /// N; 0: it was not measured since the pattern changed.
  double rounding() const { return rounding_; }
  double rounding_of_positions() const { return rounding_of_positions_; }
  /// Whether on each body no more is out of balance than the rounding of positions may leave by its own stiffness.
  bool each_body_within_rounding() const;
  /// The gradient of all effects but contact, added to `sum` [N].
  void add_gradient_without_contacts(const Increment& d, Eigen::VectorXd& sum);
  /// Their Hessian, and their unsymmetric part, which is added [N/m].
  void assemble_without_contacts(const Increment& d, SymmetricBlocks& matrix, UnsymmetricBlocks& unsymmetric);

  /// The largest fraction, at most 1, of a change of D after which smooth effects are still finite and no node has gone
  /// further than contacts were sought.
  double longest_step_fraction(const Increment& d, const Eigen::VectorXd& change);
  /// Shortens a change of D, body by body, to what takes none of its nodes further than that.
  void keep_within_reach(Eigen::VectorXd& change) const;

  /// What an effect has cost in all stages.
  struct EffectWork {
    double seconds = 0;  ///< wall time
    long built = 0, evaluations = 0, assemblies = 0;

    void archive(auto& state) { state(seconds, built, evaluations, assemblies); }
  };
  std::map<EffectKind, EffectWork> effect_work() const;
  const SolveTimes& times() const { return times_; }

  /// What it remembers from step to step, with the effects and the pattern that it has.
  void archive(auto& state) {
    state(constant_accelerations_, step_.length, step_.integration, rounding_, rounding_of_positions_);
    state(body_roundings_, times_, effect_work_, earlier_work_);
  }

 private:
  void find_contact_effects();
  void assemble_constant();
  /// Whether a body that deforms begins with its acceleration at the end where it did not in the step before, or the
  /// other way round.
  bool weights_of_inertia_changed();
  bool body_within(int body, double fraction) const;
  /// Calls with the place in BodySet::moving of each body that is looked at.
  template <class Use>
  void each_body(const Use& use) const;
  /// Zero for the bodies that are looked at.
  void clear(Eigen::VectorXd& forces) const;
  /// Adds the gradient of an effect at D and measures it.
  void add_effect(std::size_t effect, const Increment& d, const Eigen::VectorXd& part);
  void evaluate_contact(const Increment& d, Arms arms, Friction friction);
  /// The largest fraction, at most 1, of a change that takes no node of a body farther than contacts were sought.
  double fraction_within_reach(const Eigen::VectorXd& change, int body) const;
  /// An independent system and what is measured of it.
  struct System {
    std::vector<int> bodies;                                  // with nodes in it: places in BodySet::moving
    double norm = 0, scale = 0, momentum = 0, of_effect = 0;  // N
    double work = 0, works_together = 0, work_of_effect = 0;  // J: ∇Π·D, Σ |∇Π_e·D| and that of an effect
  };
  void find_systems(const BlockPattern& pattern);
  /// Norm of the part of a vector that belongs to each system.
  void measure_systems(const Eigen::VectorXd& vector, double System::*norm);
  /// The part of a vector that belongs to a moving body.
  auto of_body(auto& vector, int body) const {
    return vector.segment(3 * body_begins_[body], 3 * (body_begins_[body + 1] - body_begins_[body]));
  }
  double norm_of_body(const Eigen::VectorXd& vector, int body) const { return of_body(vector, body).norm(); }
  /// What effects other than contact that are not quadratic add at D.
  void add_hessians(const Increment& d, SymmetricBlocks& matrix);
  void add_unsymmetric(const Increment& d, UnsymmetricBlocks& sum) const;
  /// What is constant through the step, of the bodies that are looked at.
  void assign_of_step(SymmetricBlocks& matrix) const;
  void add_contact_tangents(const Increment& d, Friction friction);

  ConvergenceTolerances tolerances_;
  Composition* composition_ = nullptr;
  std::vector<char> constant_accelerations_;  ///< a body that deforms: whether it had one in the last step
  StepContext step_;                          ///< of length 0: the stage has had none yet
  double smooth_fraction_ = 1;                ///< of D at which smooth forces are taken
  SymmetricBlocks constant_;                  ///< what is constant through steps of this length of a stage …
  SymmetricBlocks of_step_;                   ///< … with what is constant through this step …
  SymmetricBlocks matrix_;                    ///< … with the rest
  UnsymmetricBlocks unsymmetric_;
  ContactPass contact_;
  std::vector<Eigen::VectorXd> contact_parts_;  ///< N, of each
  std::vector<std::size_t> contact_numbers_;    ///< among all effects
  bool pattern_changed_ = false;                ///< since constant_ was assembled
  Eigen::VectorXd gradient_, part_, zero_;
  Eigen::VectorXd frozen_;  ///< N, moments that frozen forces keep beside those that have a potential
  Increment scaled_;
  std::vector<double> works_, norms_;
  const PickedBodies* picked_ = nullptr;  ///< null: all bodies are looked at
  bool others_left_out_ = true;           ///< of the gradient
  std::vector<int> body_begins_;  ///< first degree-of-freedom block of each moving body, and the end of the last
  Eigen::VectorXd body_forces_, body_momenta_;  ///< N, of each: the largest of an effect, that of momentum
  std::vector<System> systems_;
  std::vector<int> system_of_;  ///< of each degree-of-freedom block
  double rounding_ = 0, rounding_of_positions_ = 0;
  Eigen::VectorXd body_roundings_;  ///< N, of positions, by moving bodies
  double force_scale_ = 0, momentum_scale_ = 0;
  SolveTimes times_;
  std::vector<EffectWork> effect_work_;  ///< of each effect of the stage
  std::map<EffectKind, EffectWork> earlier_work_;
};

}  // namespace talus
