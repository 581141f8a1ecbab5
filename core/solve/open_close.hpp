#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "solve/interior_method.hpp"
#include "solve/linear_system.hpp"
#include "solve/partwise_search.hpp"
#include "solve/step_balance.hpp"

namespace talus {

/// How the open–close iteration of one trial step ended.
struct Settling {
  bool settled = false;
  int iterations = 0;
  double residual = 0;     ///< N, norm of what is out of balance
  double force_scale = 0;  ///< N, what it is measured against
  /// Freedom with the largest part of the residual: of a step that was slow when it became so, of one that did not
  /// settle at its end; −1: it was easy, or what is out of balance is not a number.
  int worst_freedom = -1;
};

/// Settings of the open–close iteration; each with its consequence.
struct OpenCloseSettings {
  int iteration_limit = 160;        ///< then the step is cut
  int slow = 25;                    ///< iterations after which a step counts as hard; most take two to six
  double tolerance = 1e-10;         ///< residual over force scale at which a dynamic step has settled …
  double static_tolerance = 1e-11;  ///< … and a static one, in which forces hardly do any work
  double round_off = 1e-9;        ///< a residual below this that no longer falls is round-off, and has settled too …
  double rounding = 4;            ///< … as is one of so many roundings of a deformation times the stiffness
  LinearSettings linear;          ///< of the linear solves
  int patience = 6;               ///< iterations after which strengths are held until the rest balances
  int interior_after = 20;        ///< iterations after which an interior method tries, where …
  int interior_unknowns = 20000;  ///< … there are no more: its factors are those of an unsymmetric matrix
  int interior_limit = 50;        ///< iterations that it has
  double interior_share = 1e-3;   ///< of the force scale, out of balance at which it leaves the rest to Newton's method
  double interior_astray = 0.05;  ///< of the same: if it leaves more, at more contacts than iterations, the step is cut
  int shortenings = 20;           ///< trials for the floor of the potential along a step that has overstepped it
};

/// Finds the increment D at which all forces balance, contacts open and closed, stuck and sliding, each with the
/// strength of this very iterate: a semismooth Newton method (Alart & Curnier 1991), where the paper's section 3
/// iterates on the states. The tangent is symmetric but for friction's dependence on the normal force.
class OpenClose {
 public:
  explicit OpenClose(OpenCloseSettings settings) : settings_(settings), linear_(settings.linear) {}

  /// The effects of a stage; they must live until end_stage.
  void begin_stage(Composition& composition);
  void end_stage() { balance_.end_stage(); }
  /// The couplings of contacts have changed: finds the independent systems anew.
  void set_pattern(int nodes, std::vector<std::pair<int, int>> contact_couplings);
  /// Once after Effect::begin_step.
  void begin_step(const StepContext& step);

  /// The bodies and contacts stand at the start of a step. `d`: a first guess in, the increment out.
  Settling settle(Increment& d);
  /// Norm of the out-of-balance force at D [N].
  double residual_at(const Increment& d);
  /// Accelerations a₀ [m/s²] at the start of a stage, 3 numbers a movable node: (M + βΔ²K/(1 − α_m)) a₀ balances all
  /// forces but inertia at D = 0. What is too stiff for the step to resolve, a sticking contact for instance, is thus
  /// not set off by a load that begins with the stage; what slides goes on sliding. Between begin_step and settle.
  const Eigen::VectorXd& start_accelerations(const StepContext& step);

  /// As of the last D that was looked at.
  const StepBalance& balance() const { return balance_; }
  SolveTimes times() const;
  const LinearWork& linear_work() const { return linear_.work(); }

 private:
  using Friction = StepBalance::Friction;
  /// Of the parts that do not meet along the direction from D.
  void begin_search(const Increment& d);
  void find_direction(const Increment& d, Friction friction);
  void solve_at_the_start(Friction friction);
  /// Of the part of a search, which is left with so little where all are out of balance as now [N].
  double slight_residual() const;
  void move(Increment& d, bool early);
  void prepare(const Increment& d, double touching);
  /// Where Newton's method goes round in circles: strengths are held while the potential that there is then falls to
  /// its floor, which it does from anywhere; then they are taken anew, until a coupled step leads on. Returns the
  /// iterations that took.
  int settle_with_care(Increment& d, int limit);
  /// Where Newton's method has not settled a step so far: with care, then from inside, once, then with care again.
  /// Counts the iterations that took. False: a shorter step is the better way.
  bool settle_patiently(Increment& d, int& iterations, bool& may_go_inside);
  /// Care tells contacts apart one by one: it is not worth beginning far from balance with more contacts than
  /// iterations.
  bool is_astray(int iterations_left) const;
  /// All contacts bear and slide a little until they are told apart. Returns the iterations that took.
  int settle_from_inside(Increment& d, int limit);
  bool can_settle_from_inside() const;
  int worst_freedom() const;
  /// Takes a coupled step from D if it brings the residual down by much.
  bool coupled_step_is_worthwhile(Increment& d);
  /// A full step that closes contacts may leave far more than there was, and the next one nearly nothing.
  bool another_step_leads_on(Increment& d);
  /// D = start − share · direction of each part, and the forces there.
  void step_from_start(Increment& d, Friction friction);
  /// Along the direction, part by part.
  void go_to_the_floor(Increment& d);

  Composition* composition_ = nullptr;
  OpenCloseSettings settings_;
  StepBalance balance_;
  UnsymmetricBlocks beyond_;
  LinearSystem linear_;
  PartwiseSearch search_;
  InteriorMethod interior_;
  DisjointSets together_;
  Eigen::VectorXd part_, direction_, zero_;
  Increment scaled_, start_, second_start_, first_guess_;
  double tolerance_ = 0;  ///< of this step
  double pattern_seconds_ = 0;
};

}  // namespace talus
