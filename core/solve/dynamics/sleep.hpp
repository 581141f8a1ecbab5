#pragma once

#include <span>
#include <vector>

#include "bodies/body_set.hpp"
#include "contact/contact_point.hpp"
#include "model/solver_tolerances.hpp"

namespace talus {

/// Which blocks sleep. A block falls asleep when it and all that it touches have been slower than `tolerance` times
/// their sizes a second for some steps, none of its contacts slides, and it bears no load that changes. Asleep it
/// stands still and costs nothing; the neglected displacement is at most that speed times the time. It wakes in the
/// step that presses it otherwise (SleeperLoads), and with every stage. While fixed blocks move by prescription no
/// block sleeps.
class Sleep {
 public:
  /// `sizes`: of each body, the mesh size [m]; `tolerance` [1/s], 0: no block sleeps.
  Sleep(std::vector<double> sizes, double tolerance, const SleepTolerances& tolerances = {});

  /// All are awake. `restless`: bodies with loads or constraints by table in the stage; one flag a body.
  void begin_stage(std::vector<bool> restless);
  /// A step of `length` [s] has been accepted: the bodies that fall asleep.
  const std::vector<int>& after_step(const BodySet& bodies, const ContactSet& contacts, double length);
  /// These wake, and all sleepers from which fewer than so many `rings` of contacts lead to one of them: two rings are
  /// the bodies and whom they touch. `resting`: the contacts of sleepers.
  void wake(std::span<const int> bodies, const std::vector<RestingContact>& resting, int rings);

  const std::vector<char>& asleep() const { return asleep_; }  ///< a body
  int count() const { return count_; }                         ///< bodies that sleep now
  long wakings() const { return wakings_; }                    ///< bodies that were woken so far, but by stages

  /// What it remembers from step to step.
  void archive(auto& state) { state(asleep_, restless_, slow_for_, waited_, count_, wakings_); }

 private:
  /// Finds who is kept awake: who has not been slow for long, bears a load that changes, slides, or touches such a
  /// body.
  void keep_awake(const BodySet& bodies, const ContactSet& contacts);

  std::vector<double> sizes_;
  double tolerance_;
  int slow_steps_;
  std::vector<char> asleep_;
  std::vector<bool> restless_;
  std::vector<int> slow_for_;     ///< steps that a body has been slow
  std::vector<char> kept_awake_;  ///< a body, while it is asked
  std::vector<int> falls_asleep_;
  int waited_ = 0;  ///< steps since it was asked who falls asleep
  int count_ = 0;
  long wakings_ = 0;
};

}  // namespace talus
