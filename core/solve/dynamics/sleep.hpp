#pragma once

#include <vector>

#include "bodies/body_set.hpp"
#include "contact/contact_point.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// Which blocks sleep. A block falls asleep together with all blocks that it touches when each of them has been slower
/// than `tolerance` times its size a second for some steps, none slides, and none bears a load that changes. Asleep it
/// stands still and costs nothing; the neglected displacement is at most that speed times the time. It wakes, with all
/// that fell asleep with it, before the step in which something that is awake may touch it, and with every stage. While
/// fixed blocks move by prescription no block sleeps.
class Sleep {
 public:
  /// `sizes`: of each body, the mesh size [m]; `tolerance` [1/s], 0: no block sleeps.
  Sleep(std::vector<double> sizes, double tolerance, const SleepTolerances& tolerances = {});

  /// All are awake. `restless`: bodies with loads or constraints by table in the stage; one flag a body.
  void begin_stage(std::vector<bool> restless);
  /// A step of `length` [s] has been accepted; true if some body falls asleep.
  bool after_step(const BodySet& bodies, const ContactSet& contacts, double length);
  /// Contacts for the next step have been sought; true if some body wakes.
  bool wake_touched(const BodySet& bodies, const ContactSet& contacts);

  const std::vector<char>& asleep() const { return asleep_; }  ///< a body
  int count() const { return count_; }                         ///< bodies that sleep now
  long wakings() const { return wakings_; }                    ///< bodies that woke by touch so far

  /// What it remembers from step to step.
  void archive(auto& state) { state(asleep_, restless_, slow_for_, group_, kept_awake_, waited_, count_, wakings_); }

 private:
  int group_of(int body);
  void join(const BodySet& bodies, const ContactSet& contacts);

  std::vector<double> sizes_;
  double tolerance_;
  int slow_steps_;
  std::vector<char> asleep_;
  std::vector<bool> restless_;
  std::vector<int> slow_for_;     ///< steps that a body has been slow
  std::vector<int> group_;        ///< of sleepers: what they wake with; else a body of the same group
  std::vector<char> kept_awake_;  ///< a group, while it is asked
  int waited_ = 0;                ///< steps since groups were looked at
  int count_ = 0;
  long wakings_ = 0;
};

}  // namespace talus
