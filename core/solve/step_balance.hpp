#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "effects/compose.hpp"
#include "solve/solve_times.hpp"

namespace talus {

/// The balance of a step: what all effects of a stage together leave out of balance at an increment D, ∇Π(D), and its
/// derivatives. Counts and times what each effect costs. The bodies and contacts stand at the start of the step.
class StepBalance {
 public:
  /// Strengths in shear: those of the D that is looked at, or those of the iterate that they are held at.
  enum class Friction { coupled, lagged };

  /// The effects of a stage; they must live until end_stage.
  void begin_stage(Composition& composition);
  void end_stage();
  /// The couplings of contacts have changed.
  void set_pattern(int nodes, std::vector<std::pair<int, int>> contact_couplings);
  /// Assembles what stays the same through a step, where it has changed; called once after Effect::begin_step. Whether
  /// the step is of another kind than the one before, so that a factor of its matrix does not serve for this one.
  bool begin_step(const StepContext& step);

  /// Finds the gradient at D, and what it is measured against.
  void evaluate(const Increment& d, Friction friction);
  const Eigen::VectorXd& gradient() const { return gradient_; }  ///< N, at the last D that was looked at
  double residual() const { return gradient_.norm(); }           ///< N
  /// Holds at D, where the gradient is known, what no potential has: strengths, and what mean arms change in moments.
  void hold(const Increment& d);
  /// The gradient at D = 0 without inertia's force.
  void evaluate_without_inertia();
  double force_scale() const { return force_scale_; }  ///< N, of the forces that the last gradient is the sum of
  /// ∇Π_e·D of each effect at the last D that was looked at [J].
  const std::vector<double>& works() const { return works_; }
  /// Norm of inertia's force over that of the largest force, at the last D: how far from static equilibrium.
  double imbalance() const;

  /// Assembles the Hessian at D. Contacts that are open by less than `touching`, of the mesh size, count as closed.
  void assemble(const Increment& d, double touching);
  const SymmetricBlocks& matrix() const { return matrix_; }  ///< N/m, as last assembled
  /// Finds by that matrix what the rounding of deformations, and of where a step begins, may leave in the residual.
  void measure_rounding();
  /// N; 0: it was not measured since the pattern changed.
  double rounding() const { return rounding_; }
  double rounding_of_positions() const { return rounding_of_positions_; }
  /// Adds what the derivative of the gradient has beyond the Hessian [N/m].
  void add_beyond(const Increment& d, UnsymmetricBlocks& beyond);

  /// Without contacts: adds the gradient [N]; sets the Hessian and adds what is beyond it [N/m].
  void add_gradient_of_rest(const Increment& d, Eigen::VectorXd& sum);
  void assemble_rest(const Increment& d, SymmetricBlocks& matrix, UnsymmetricBlocks& beyond);

  /// Of a change of D that smooth effects bear, and that leads no further than contacts were sought; at most 1.
  double longest_share(const Increment& d, const Eigen::VectorXd& change);

  /// What an effect has cost in all stages.
  struct EffectWork {
    double seconds = 0;  ///< wall time
    long built = 0, evaluations = 0, assemblies = 0;
  };
  std::map<std::string, EffectWork> effect_work() const;  ///< by name
  const SolveTimes& times() const { return times_; }

 private:
  enum class Contacts { included, left_out };
  void assemble_constant();
  /// What effects that are not quadratic add at D.
  void add_hessians(const Increment& d, Contacts contacts, SymmetricBlocks& matrix);
  void add_unsymmetric(const Increment& d, Contacts contacts, UnsymmetricBlocks& beyond) const;

  Composition* composition_ = nullptr;
  StepContext step_;              ///< of length 0: the stage has had none yet
  double share_ = 1;              ///< of D at which smooth forces are taken
  SymmetricBlocks constant_;      ///< what stays the same through steps of this length of a stage …
  SymmetricBlocks of_step_;       ///< … with what stays the same through this step …
  SymmetricBlocks matrix_;        ///< … with the rest
  bool pattern_changed_ = false;  ///< since constant_ was assembled
  Eigen::VectorXd gradient_, part_, zero_;
  Eigen::VectorXd held_;  ///< N, moments that lagged forces go on with beside those that have a potential
  Increment scaled_;
  std::vector<double> works_, norms_;
  double rounding_ = 0, rounding_of_positions_ = 0;
  double force_scale_ = 0, momentum_scale_ = 0;
  SolveTimes times_;
  std::vector<EffectWork> effect_work_;  ///< of each effect of the stage
  std::map<std::string, EffectWork> earlier_work_;
};

}  // namespace talus
