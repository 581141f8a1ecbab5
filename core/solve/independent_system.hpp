#pragma once

#include <memory>
#include <vector>

#include "solve/coupled_parts.hpp"
#include "solve/dense_solver.hpp"
#include "solve/linear_work.hpp"
#include "solve/sparse_part.hpp"
#include "solve/tangent_factor.hpp"

namespace talus {

/// Equations that share no unknown with the others, such as those of a block that can touch no other. Small ones are
/// solved densely. A large one that has just changed is taken apart, where nothing couples its parts but contacts that
/// are open: small parts are solved densely, too, larger ones with a factor of their own. Of what is left a Cholesky
/// factor of the symmetric part of all, as old as it serves, preconditions GMRES on all of the tangent; where the
/// factor is that of this very matrix and the matrix all of the tangent, it solves it alone.
class IndependentSystem {
 public:
  /// `nodes`: ascending; `pattern`: of these nodes among themselves. Orders and analyses it.
  IndependentSystem(std::vector<int> nodes, BlockPattern pattern);

  int first_node() const { return nodes_.front(); }
  int size() const { return static_cast<int>(nodes_.size()); }
  bool is_of(const std::vector<int>& nodes, const BlockPattern& pattern) const {
    return nodes_ == nodes && matrix_.pattern() == pattern;
  }
  /// The matrix is about to change by more than its factor can serve for.
  void outdate() { outdated_ = true; }

  /// Takes its share of the right-hand side of all, without anything beyond the symmetric matrix. Returns its norm.
  double take_right_side(const Eigen::VectorXd& b);
  /// Two nodes of it, by their numbers in it, with what is beyond the symmetric matrix.
  void take_beyond(const UnsymmetricBlocks::Pair& pair) { beyond_.push_back(pair); }
  /// Writes the solution into the unknowns of all; zero in small parts whose right-hand sides are no larger than
  /// `negligible`, together in norm. Throws NotPositiveDefinite with the node among all.
  void solve(const SymmetricBlocks& whole, const LinearSettings& settings, double negligible, LinearWork& work,
             Eigen::VectorXd& x);

 private:
  struct Sparse {
    TangentFactor factor;
    int patience = 5;    ///< GMRES iterations that cost as much as a factor
    int iterations = 0;  ///< of the last solution
    CoupledParts parts;
    std::vector<DenseSolver> of_size;  ///< for a part of so many nodes: kept, so that each size is allocated once
    SparsePart large_part;
    Eigen::VectorXd right, solution, solution_of_parts;
  };
  void solve_densely(LinearWork& work);
  void solve_parts(const LinearSettings& settings, double negligible, LinearWork& work);
  void solve_sparsely(const LinearSettings& settings, LinearWork& work);
  void factor(LinearWork& work);

  std::vector<int> nodes_;  ///< among all
  std::vector<int> own_;    ///< their numbers here, 0, 1, …
  SymmetricBlocks matrix_;
  std::vector<UnsymmetricBlocks::Pair> beyond_;
  Eigen::VectorXd right_, solution_;
  bool current_ = false;   ///< the factor is that of the symmetric matrix as it is
  int solved_before_ = 0;  ///< times that the symmetric matrix as it is was solved
  bool outdated_ = true;   ///< the factor, if there is any, is too old to precondition
  bool symmetric_ = true;  ///< the dense factor has nothing beyond the symmetric matrix
  DenseSolver dense_;
  std::unique_ptr<Sparse> sparse_;  ///< null: it is small
};

}  // namespace talus
