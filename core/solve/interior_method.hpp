#pragma once

#include <functional>

#include "effects/interior_contacts.hpp"
#include "solve/solve_times.hpp"
#include "solve/sparse_lu.hpp"

namespace talus {

/// A way to the balance of a step that no order in which contacts open, close, stick and slide can send round in
/// circles: all bear and slide a little until they are told apart (InteriorContacts). Each iteration predicts how far
/// the products of force and way can fall at once, and corrects what that leaves (Mehrotra 1992); it costs two solves
/// with one factor. It begins far from where it ends whatever the first guess, which is why it comes after Newton's
/// method, and leads to where Newton's method finishes.
class InteriorMethod {
 public:
  /// The step, its loose contacts apart.
  struct Step {
    const BodySet& bodies;
    const ContactLinks& links;
    const BlockPattern& pattern;
    std::function<void(const Increment& d, Eigen::VectorXd& sum)> add_gradient;                            ///< N
    std::function<void(const Increment& d, SymmetricBlocks& matrix, UnsymmetricBlocks& beyond)> assemble;  ///< N/m
    /// Of a change of D that the rest bears, at most 1.
    std::function<double(const Increment& d, const Eigen::VectorXd& change)> longest_share;
    /// Whether Newton's method leads on from D with the contacts' own law.
    std::function<bool(const Increment& d)> is_near;
  };

  /// Goes on from D until it is near, or in vain. Returns the iterations that took.
  int approach(const Step& step, int limit, Increment& d);
  int points() const { return contacts_.size(); }  ///< contact points that the last approach told apart, or tried to
  const SolveTimes& times() const { return times_; }

 private:
  /// Finds the rest at D, where contacts begin; false: without them the matrix is singular.
  bool begin(const Step& step, const Increment& d);
  /// Gradient and matrix without contacts.
  void find_rest(const Step& step, const Increment& d);
  /// Of the contacts and of D, to `end_`, with the rest at D; false: the matrix is singular.
  bool find_changes(const Step& step, const Increment& d);
  void solve(const Step& step, const Increment& d);

  InteriorContacts contacts_;
  SymmetricBlocks matrix_;
  UnsymmetricBlocks beyond_;
  SparseLu lu_;
  Eigen::VectorXd rest_, right_, direction_;
  Increment start_, end_;
  SolveTimes times_;
};

}  // namespace talus
