#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/disjoint_sets.hpp"

namespace talus {

/// Line searches of bodies that do not meet on their way, each for itself: a contact that closes in one heap of blocks
/// is no reason for another heap to hold back. All go along one vector of directions, each part by a share of its own.
/// A part is pending until it is left where it is. Unknowns come three a freedom.
class PartwiseSearch {
 public:
  /// Where a part stands, and where its search began.
  struct State {
    double residual_before = 0, residual = 0;  ///< N, norm of the gradient
    double slope_before = 0, slope = 0;        ///< J, of the potential along the whole step −direction
  };

  /// All are one part.
  void set_size(int freedoms);
  /// Freedoms that go together; numbers the parts.
  void set_parts(DisjointSets& together);

  /// All parts are pending, by a share of 1.
  void take_all();
  /// Searches of pending parts begin here, by a share of 1; those without a direction are left.
  void begin(const Eigen::VectorXd& gradient, const Eigen::VectorXd& direction);
  bool any_pending() const;
  /// The gradient of pending parts, 0 elsewhere.
  void pick_pending(const Eigen::VectorXd& gradient, Eigen::VectorXd& picked) const;
  /// −share · direction.
  void step_along(const Eigen::VectorXd& direction, Eigen::VectorXd& step) const;
  /// Leaves pending parts of which `leads_on(State)` holds at this gradient where they are.
  template <typename Judge>
  void leave(const Eigen::VectorXd& gradient, const Eigen::VectorXd& direction, const Judge& leads_on) {
    look(gradient, direction);
    for (Part& part : parts_) part.pending = part.pending && !leads_on(part.state);
  }
  /// Pending parts of `d` go back to `start`; the others of `start` follow to `d`.
  void go_back(Eigen::VectorXd& start, Eigen::VectorXd& d) const;
  /// At this gradient: leaves parts at the floor of their potential, or that a full step has not led beyond it, or that
  /// are out of balance by less than `slight` [N], and chooses the share by which the others go next. Whether any is
  /// pending.
  bool narrow(const Eigen::VectorXd& gradient, const Eigen::VectorXd& direction, double slight);

 private:
  struct Point {
    double share, slope;
  };
  struct Part {
    State state;
    bool pending = true, at_full_step = true;
    double share = 1;
    Point low{}, high{};  ///< that the floor lies between
  };
  void look(const Eigen::VectorXd& gradient, const Eigen::VectorXd& direction);
  static void narrow(Part& part);
  std::vector<int> part_of_;
  std::vector<Part> parts_;
};

}  // namespace talus
