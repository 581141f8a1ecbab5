#pragma once

#include "effects/compose.hpp"
#include "solve/cholesky.hpp"

namespace talus {

/// Wall seconds of the parts of an iteration, and of each effect in Composition's order.
struct SolveTimes {
  double assemble = 0, factor = 0, solve = 0, update = 0;
  std::vector<double> effects;
};

/// How the open–close iteration of one trial step ended.
struct Settling {
  bool settled = false;
  int iterations = 0;
  double residual = 0;     ///< N, norm of what is out of balance
  double force_scale = 0;  ///< N, what it is measured against
  int worst_node = -1;     ///< movable node with the largest part of the residual
};

/// Settings of the open–close iteration; each with its consequence.
struct OpenCloseSettings {
  int iteration_limit = 20;  ///< then the step is cut
  double tolerance = 1e-9;   ///< residual over force scale at which a step has settled
  double round_off = 1e-7;   ///< a residual below this that no longer falls is round-off, and has settled too
  double overshoot = 0.5;    ///< a full step whose slope turns round by more than this is shortened
  int shortenings = 5;
};

/// Finds the increment D that minimises the sum of the effects, with the friction strength of each contact taken from
/// the normal force of the last iteration, until that changes nothing any more (paper, section 3). In effect Newton's
/// method on a potential that is quadratic but for the opening and closing, sticking and sliding of contacts.
class OpenClose {
 public:
  OpenClose(Composition& composition, OpenCloseSettings settings);

  /// The couplings of contacts have changed: orders and analyses anew.
  void set_pattern(int nodes, std::vector<std::pair<int, int>> contact_couplings);

  /// The bodies and contacts stand at the start of a step. `d`: a first guess in, the increment out.
  Settling settle(Increment& d);

  /// Norm of the out-of-balance force at D [N]; makes no change to D.
  double residual_at(const Increment& d);
  /// Assembles what stays the same through a step; called once after Effect::begin_step.
  void begin_step();

  const SolveTimes& times() const { return times_; }

 private:
  void evaluate(const Increment& d);
  void assemble(const Increment& d);
  void move(Increment& d);

  Composition& composition_;
  OpenCloseSettings settings_;
  SymmetricBlocks constant_, matrix_;
  Cholesky cholesky_;
  Eigen::VectorXd gradient_, part_, step_;
  double force_scale_ = 0, momentum_scale_ = 0;
  SolveTimes times_;
};

}  // namespace talus
