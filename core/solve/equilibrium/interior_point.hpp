#pragma once

#include <functional>

#include "bodies/picked_bodies.hpp"
#include "linear/dense_solver.hpp"
#include "linear/sparse_lu.hpp"
#include "solve/equilibrium/interior_point_contacts.hpp"
#include "solve/equilibrium/solve_times.hpp"

namespace talus {

/// A primal–dual interior-point method for the equilibrium of a step. No order in which contacts open, close, stick and
/// slide can send it round in circles, because all of them bear and slide a little until they are told apart
/// (InteriorPointContacts). Each iteration predicts how far the complementarity of all contacts can fall at once, and
/// corrects what that leaves (Mehrotra 1992); it takes two solves with one factor. It starts far from the solution
/// whatever the first guess, which is why it is tried after Newton's method, and ends where Newton's method converges.
class InteriorPoint {
 public:
  /// The equations of a step, its loose contacts apart.
  struct Problem {
    const BodySet& bodies;
    const ContactLinks& links;
    const BlockPattern& pattern;
    const PickedBodies* picked = nullptr;  ///< few, that move alone; null: all
    Arms arms = Arms::end;
    std::function<void(const Increment& d, Eigen::VectorXd& sum)> add_gradient;                                 ///< N
    std::function<void(const Increment& d, SymmetricBlocks& matrix, UnsymmetricBlocks& unsymmetric)> assemble;  ///< N/m
    /// The largest fraction, at most 1, of a change of D that everything but the contacts allows.
    std::function<double(const Increment& d, const Eigen::VectorXd& change)> longest_step_fraction;
    /// Whether Newton's method may take over at D, with the contacts' own law.
    std::function<bool(const Increment& d)> is_near;
  };

  explicit InteriorPoint(const InteriorPointTolerances& tolerances = {})
      : tolerances_(tolerances), contacts_(tolerances) {}

  /// Iterates from D until it is near the solution, or gives up. Returns the number of iterations.
  int approach(const Problem& problem, int limit, Increment& d);
  int points() const { return contacts_.size(); }  ///< contact points of the last approach
  /// Approaches that ended because a matrix had no LU factor: it is singular, or there is not enough memory.
  long failed_factorisations() const { return failed_factorisations_; }
  const SolveTimes& times() const { return times_; }

  /// What it remembers from step to step.
  void archive(auto& state) { state(lu_, failed_factorisations_, times_); }

 private:
  /// Evaluates gradient and matrix at D and chooses where contacts begin. False: without contacts the matrix has no
  /// factor.
  bool begin(const Problem& problem, const Increment& d);
  void assemble_without_contacts(const Problem& problem, const Increment& d);
  /// Changes of the contacts and of D, which would become `end_`. False: the matrix has no factor.
  bool find_changes(const Problem& problem, const Increment& d);
  /// Of the matrix with the unsymmetric part. False: it has no factor.
  bool factor(const Problem& problem);
  /// Direction for the right-hand side, zero for bodies that do not move.
  void solve_with_factor(const Problem& problem);
  void solve(const Problem& problem, const Increment& d);

  InteriorPointTolerances tolerances_;
  InteriorPointContacts contacts_;
  SymmetricBlocks matrix_;
  UnsymmetricBlocks unsymmetric_;
  SparseLu lu_;
  DenseSolver dense_;  // of few bodies
  Eigen::VectorXd picked_right_, picked_direction_;
  std::vector<int> picked_points_;
  Eigen::VectorXd gradient_, right_, direction_;
  Increment start_, end_;
  long failed_factorisations_ = 0;
  SolveTimes times_;
};

}  // namespace talus
