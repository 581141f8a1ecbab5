#pragma once

#include <deque>
#include <optional>

namespace talus {

/// How long the rest of a run will take, from how fast it has gone of late: contact makes steps slower as blocks meet,
/// so the mean over the whole run would mislead.
class TimeLeft {
 public:
  /// `spent`: s of work, pauses left out, ascending; `fraction`: done of the whole, 0…1, not descending.
  void update(double spent, double fraction);
  /// s; empty until there is enough to go by.
  std::optional<double> seconds() const;
  double spent() const { return moments_.empty() ? 0 : moments_.back().spent; }

 private:
  struct Snapshot {
    double spent, fraction;
  };
  std::deque<Snapshot> moments_;  ///< of the last third of the work
};

}  // namespace talus
