#pragma once

#include <memory>
#include <vector>

#include "base/state_archive.hpp"
#include "base/trials.hpp"
#include "linear/coupled_parts.hpp"
#include "linear/dense_solver.hpp"
#include "linear/incomplete_solver.hpp"
#include "linear/linear_work.hpp"
#include "linear/sparse_part.hpp"
#include "linear/tangent_factor.hpp"

namespace talus {

/// Equations that share no unknown with the others, such as those of a block that can touch no other.
/// - A small system is solved with a dense factor.
/// - A large one is solved by GMRES with an incomplete factor. Where that fails it is left out for some time, and
/// - one whose matrix has just changed is split where only open contacts join its parts: small parts are solved with
///   dense factors, larger ones with a sparse factor of their own.
/// - The rest is solved by GMRES, preconditioned with a Cholesky factor of the symmetric part of the whole system. An
///   old factor is kept while it converges fast enough. Where the factor belongs to the present matrix and there is no
///   unsymmetric part, one solve with it suffices.
class IndependentSystem {
 public:
  /// `nodes`: ascending; `pattern`: of these nodes among themselves.
  IndependentSystem(std::vector<int> nodes, BlockPattern pattern);

  int first_node() const { return nodes_.front(); }
  int size() const { return static_cast<int>(nodes_.size()); }
  bool is_of(const std::vector<int>& nodes, const BlockPattern& pattern) const {
    return nodes_ == nodes && matrix_.pattern() == pattern;
  }
  /// The matrix is about to change so much that its factor is no good preconditioner any more.
  void outdate() { outdated_ = true; }
  /// The next solution is with a whole factor of its matrix.
  void demand_factor() { outdated_ = needs_factor_ = true; }

  /// Takes its part of the global right-hand side. Returns the norm of that part.
  double take_right_side(const Eigen::VectorXd& b);
  /// The unsymmetric part has so many pairs, each of which is taken then: two nodes, by their numbers in this system.
  void expect_unsymmetric(int pairs) { unsymmetric_.resize(pairs); }
  void take_unsymmetric(int place, const UnsymmetricBlocks::Pair& pair) { unsymmetric_[place] = pair; }
  /// Writes the solution into the global unknowns; zero in small parts whose right-hand sides are, together in norm, no
  /// larger than `negligible`. Throws NotPositiveDefinite with the global node.
  void solve(const SymmetricBlocks& whole, const LinearSettings& settings, double negligible, Trials& trials,
             LinearWork& work, Eigen::VectorXd& x);

  /// What it remembers from one solution to the next, with the nodes and the pattern that it has.
  void archive(StateArchive& state);

 private:
  struct Sparse {
    IncompleteSolver incomplete;
    TangentFactor factor;
    bool analysed = false;
    int patience = 5;    ///< GMRES iterations that cost as much as a factor
    int iterations = 0;  ///< of the last solution
    CoupledParts parts;
    std::vector<DenseSolver> of_size;  ///< for a part of so many nodes: kept, so that each size is allocated once
    SparsePart large_part;
    Eigen::VectorXd right, solution, solution_of_parts;
  };
  /// Orders the equations, once.
  void analyse();
  void solve_densely(LinearWork& work);
  /// With an incomplete one. False: it was not tried, or not within the limit.
  bool solve_without_factor(const LinearSettings& settings, Trials& trials, LinearWork& work);
  void solve_parts(const LinearSettings& settings, double negligible, LinearWork& work);
  void solve_sparsely(const LinearSettings& settings, LinearWork& work);
  void factor(LinearWork& work);

  std::vector<int> nodes_;  ///< among all
  std::vector<int> own_;    ///< their numbers here, 0, 1, …
  SymmetricBlocks matrix_;
  std::vector<UnsymmetricBlocks::Pair> unsymmetric_;
  Eigen::VectorXd right_, solution_;
  bool current_ = false;       ///< the factor belongs to the present symmetric matrix
  int solved_before_ = 0;      ///< times that the present symmetric matrix was solved
  bool outdated_ = true;       ///< the factor, if there is any, is no good preconditioner any more
  bool needs_factor_ = false;  ///< a whole one, for the next solution
  bool symmetric_ = true;      ///< the dense factor was made without an unsymmetric part
  DenseSolver dense_;
  std::unique_ptr<Sparse> sparse_;  ///< null: it is small
};

}  // namespace talus
