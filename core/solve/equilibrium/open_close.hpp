#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "linear/linear_system.hpp"
#include "model/solver_settings.hpp"
#include "solve/equilibrium/contact_states.hpp"
#include "solve/equilibrium/interior_point.hpp"
#include "solve/equilibrium/nonlinear_elimination.hpp"
#include "solve/equilibrium/partwise_line_search.hpp"
#include "solve/equilibrium/step_residual.hpp"

namespace talus {

/// How the open–close iteration of one trial step ended.
struct OpenCloseResult {
  bool converged = false;
  int iterations = 0;
  double residual = 0;     ///< N, norm of the gradient
  double force_scale = 0;  ///< N, what it is measured against
  /// Degree-of-freedom block with the largest part of the residual: of a hard step when it became hard, of one that did
  /// not converge at its end. −1: the step was easy, or the residual is not a number.
  int worst_dof_block = -1;
};

/// Finds the increment D at which all forces balance: which contacts are open and closed, which stick and slide. It is
/// a semismooth Newton method (Alart & Curnier 1991): each iteration takes friction strengths from its own normal
/// forces, where the paper's section 3 iterates on the states of contacts. The tangent is symmetric, except that
/// friction depends on the normal force. An iteration is
///   1. assemble the tangent at D, solve for Newton's direction;
///   2. try the full increment, and keep it where it reduces the residual, or does once the bodies that it brought
///      farther out of balance are balanced by themselves;
///   3. elsewhere freeze friction, so that there is a potential, and search for its minimum along the direction.
/// Bodies that are left far out of balance by an iteration that balances nearly all others are balanced by themselves.
/// Where a few iterations do not converge, the interior-point method begins anew; what it does not apply to, frozen
/// friction alone brings on.
class OpenClose {
 public:
  explicit OpenClose(const SolverTolerances& tolerances = {}, int iteration_limit = SolverSettings{}.open_close_limit,
                     OpenCloseMethod method = OpenCloseMethod::newton, bool balances_alone = true)
      : tolerances_(tolerances.convergence),
        iteration_limit_(iteration_limit),
        method_(method),
        balances_alone_(balances_alone),
        residual_(tolerances.convergence),
        linear_settings_{.tolerance = tolerances.convergence.gmres,
                         .limit = tolerances.convergence.gmres_limit,
                         .incomplete_limit = tolerances.convergence.incomplete_limit},
        linear_(linear_settings_),
        search_(tolerances.convergence),
        elimination_(tolerances.elimination, linear_settings_),
        elimination_tolerances_(tolerances.elimination),
        interior_(tolerances.interior_point) {}

  /// The effects of a stage; they must live until end_stage. A step has converged, too, once no body is out of balance
  /// by more than `body_residual` of the forces on it; 0: by nothing.
  void begin_stage(Composition& composition, double body_residual = 0);
  void end_stage() { residual_.end_stage(); }
  /// Effects were put into the composition of the stage; a pattern is to be set.
  void put_in(const PutIn& where) { residual_.put_in(where); }
  /// The couplings of contacts have changed: finds the independent systems anew.
  void set_pattern(int nodes, std::vector<std::pair<int, int>> contact_couplings);
  /// Once after Effect::begin_step, and again where inertia has changed.
  void begin_step(const StepContext& step);

  /// Iterates from the first guess `d` to the increment, which it leaves there. The bodies and contacts stand at the
  /// start of a step. It ends as converged, too, once no body is out of balance by more than `enough` of the forces on
  /// it.
  OpenCloseResult converge(Increment& d, double enough = 0);
  /// Contacts of a converged step were changed: balances the bodies by themselves that this leaves far out of balance,
  /// with all that touch them. False: there are none, they are too many, or it does not get far.
  bool balance_changed(Increment& d);
  /// Is called with each iteration and told the force that is out of balance [N]: a hard step takes hundreds.
  void watch(std::function<void(double unbalanced)> each_iteration) { watch_ = std::move(each_iteration); }
  /// Contacts are about to be found anew: none is held in a state any more.
  void release_states();
  /// Norm of the gradient at D [N].
  double residual_at(const Increment& d);
  /// Accelerations a₀ [m/s²] at the start of a stage, 3 numbers a movable node: (M + βΔ²K/(1 − α_m)) a₀ balances all
  /// forces but inertia at D = 0. So a load that begins with the stage does not excite what is too stiff for the step
  /// to resolve, such as a sticking contact; what slides goes on sliding. Between begin_step and converge.
  const Eigen::VectorXd& start_accelerations(const StepContext& step);

  const StepResidual& residual() const { return residual_; }  ///< as of the last D that was evaluated
  SolveTimes times() const;
  LinearWork linear_work() const;
  const InteriorPoint& interior_point() const { return interior_; }
  const StepResidual::EffectWork& work_alone() const { return alone_; }  ///< of balancing bodies by themselves

  /// What it remembers from step to step, with the effects that it has. `pattern_holds`: that of the last step still
  /// does; else one has to be set before the next.
  void archive(StateArchive& state, bool pattern_holds);

 private:
  using Friction = StepResidual::Friction;
  void follow_pattern();
  /// An iteration begins from D: tells who watches, assembles the tangent and measures what rounding it makes.
  void assemble(const Increment& d, double touching, Friction friction);
  /// Newton's direction from D of the parts that are pending, no longer than bodies may go in an iteration.
  void find_direction(const Increment& d, Friction friction);
  void solve_at_step_start(Friction friction);
  /// Finds the parts that do not meet along the direction from D, and begins their line searches.
  void begin_search(const Increment& d);
  /// D = start − fraction · direction of each part, and the forces there.
  void advance_from_start(Increment& d, Friction friction);
  /// Searches along the direction, part by part, for the minimum of the potential with frozen friction.
  void minimise_along_direction(Increment& d);
  /// Whether an independent system has converged as far as is asked for this time.
  bool balances(int system) const;
  /// Of the systems that have not converged [N].
  double norm_left() const;
  /// What may be left in the part of each degree-of-freedom block without searching further [N].
  void find_negligible();

  /// The paper's iteration, section 3: rounds in each of which contacts keep their states and friction is that of the
  /// last round (36), so that the step is one linear system; until a round leaves the states as they were.
  OpenCloseResult converge_by_states(Increment& d);
  /// Newton's method with its fallbacks, in so many iterations at most.
  OpenCloseResult converge_within(int limit, bool interior_point_left, Increment& d);
  /// Balances bodies by themselves that are far out of balance while nearly all others are not (NonlinearElimination).
  void balance_alone(Increment& d, Trials& trials);
  /// The same, once they are picked, in so many iterations at most. Whether that reduces their residual well; D stays
  /// if it does not at all.
  bool balance_picked(Increment& d, int limit);
  /// D is what the bodies that are looked at begin with: they go back to it where they get nowhere.
  void begin_with(const Increment& d);
  /// One iteration of Newton's method. `early`: contacts may close together, at the price of a larger residual.
  void iterate(Increment& d, bool early);
  void note_body_residuals();
  /// A full increment may be as good as it should be but for a few bodies, such as a chip whose contacts it has pressed
  /// together: it is kept where these, balanced by themselves, leave less than there was `before` [N].
  bool full_increment_leads_on(Increment& d, double before);
  /// A full increment that closes contacts may leave a far larger residual, and the next one nearly none.
  bool another_iteration_leads_on(Increment& d);

  /// What is tried where Newton's method goes round in circles: once the interior-point method, then frozen friction.
  /// Adds its iterations. False: a shorter step is the better way.
  bool converge_with_fallbacks(Increment& d, int limit, int& iterations, bool& interior_point_left);
  /// Friction stays frozen while the potential that there is then falls to its minimum, which it does from anywhere;
  /// then it is taken anew, until a coupled iteration leads on. Returns the number of iterations.
  int converge_with_frozen_friction(Increment& d, int limit);
  /// Keeps a coupled iteration from D if it reduces the residual by much.
  bool coupled_iteration_leads_on(Increment& d);
  bool interior_point_applies() const;
  /// Returns the number of iterations.
  int approach_by_interior_point(Increment& d, int limit);
  /// Frozen friction decides contacts one by one: far from equilibrium with more contacts than iterations it is in
  /// vain.
  bool is_hopeless(int iterations_left) const;

  bool has_converged(const OpenCloseResult& now, bool stalled, const Increment& d) const;
  int worst_dof_block() const;

  Composition* composition_ = nullptr;
  std::function<void(double unbalanced)> watch_;  ///< empty: nobody does
  ConvergenceTolerances tolerances_;
  int iteration_limit_;
  OpenCloseMethod method_;
  bool balances_alone_;
  ContactStates states_;  ///< of the paper's method
  StepResidual residual_;
  const UnsymmetricBlocks nothing_;
  LinearSettings linear_settings_;
  LinearSystem linear_;
  PartwiseLineSearch search_;
  NonlinearElimination elimination_;
  EliminationTolerances elimination_tolerances_;
  Trials trials_alone_, trials_full_;
  InteriorPoint interior_;
  DisjointSets together_;
  Eigen::VectorXd part_, direction_, zero_;
  Increment scaled_, start_, second_start_;
  std::vector<Increment> begun_with_;   ///< by all bodies, by those that are balanced alone, by few among these, …
  std::vector<double> body_residuals_;  ///< N, a body: where the iteration began
  struct Iterate {
    Increment start, end;
    Eigen::VectorXd direction;
    PartwiseLineSearch search;
  };
  Iterate full_;  ///< the full increment, while bodies are balanced to judge it
  bool is_dynamic_ = false;
  double tolerance_ = 0;      ///< relative residual of all bodies together at which this step has converged …
  double body_residual_ = 0;  ///< … and of each alone
  double enough_ = 0;         ///< of the forces on each body, that may be out of balance this time
  std::vector<double> negligible_, negligible_in_system_;  ///< N, of each degree-of-freedom block, of each system
  double pattern_seconds_ = 0, elimination_seconds_ = 0;
  StepResidual::EffectWork alone_;
};

}  // namespace talus
