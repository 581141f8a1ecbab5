#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// Line searches of bodies that do not come into contact in an increment, each for itself: a contact that closes in one
/// heap of blocks is no reason for another heap to hold back. All parts go along one vector of directions, each by a
/// step fraction of its own. A part is pending until its fraction is decided. Unknowns come three a degree-of-freedom
/// block.
class PartwiseLineSearch {
 public:
  /// Where a part stands, and where its search began.
  struct State {
    double residual_before = 0, residual = 0;  ///< N, norm of the gradient
    double slope_before = 0, slope = 0;        ///< J, of the potential along the full increment −direction
    double negligible = 0;                     ///< N, of which no more need be left
  };

  explicit PartwiseLineSearch(const ConvergenceTolerances& tolerances = {}) : tolerances_(tolerances) {}

  /// All degree-of-freedom blocks are one part.
  void set_size(int dof_blocks);
  /// Degree-of-freedom blocks that go together; numbers the parts.
  void set_parts(DisjointSets& together);

  /// All parts are pending, with a fraction of 1.
  void set_all_pending();
  /// Searches of pending parts begin here, with a fraction of 1; parts without a direction are done. `negligible`: of
  /// the part of each degree-of-freedom block [N]; none: 0.
  void begin(const Eigen::VectorXd& gradient, const Eigen::VectorXd& direction,
             std::span<const double> negligible = {});
  bool any_pending() const;
  /// The gradient of pending parts, 0 elsewhere.
  void pick_pending(const Eigen::VectorXd& gradient, Eigen::VectorXd& picked) const;
  /// −fraction · direction.
  void increment_along(const Eigen::VectorXd& direction, Eigen::VectorXd& increment) const;
  /// Pending parts for which `keeps(State)` holds at this gradient stay where they are, and are done.
  template <typename Judge>
  void keep(const Eigen::VectorXd& gradient, const Eigen::VectorXd& direction, const Judge& keeps) {
    look(gradient, direction);
    for (Part& part : parts_) part.pending = part.pending && !keeps(part.state);
  }
  /// Pending parts of `d` go back to `start`; the others of `start` follow to `d`.
  void go_back(Eigen::VectorXd& start, Eigen::VectorXd& d) const;
  /// A round of the search at this gradient. Done are parts at the minimum of their potential, parts whose full
  /// increment has not overshot it, and parts with a negligible residual. Chooses the next fraction of the others.
  /// Whether any is pending.
  bool narrow(const Eigen::VectorXd& gradient, const Eigen::VectorXd& direction);

 private:
  struct Point {
    double fraction, slope;
  };
  struct Part {
    State state;
    bool pending = true, at_full_increment = true;
    double fraction = 1;
    Point low{}, high{};  ///< that the minimum lies between
  };
  void look(const Eigen::VectorXd& gradient, const Eigen::VectorXd& direction);
  void narrow(Part& part) const;

  ConvergenceTolerances tolerances_;
  std::vector<int> part_of_;
  std::vector<Part> parts_;
};

}  // namespace talus
