#pragma once

#include <map>
#include <string>
#include <vector>

#include "mesh/block.hpp"
#include "results/frame.hpp"
#include "results/run_report.hpp"

namespace talus {

class Simulation;

/// Watches a run for what deserves a mark on its timeline: a joint between two blocks that opened and stayed open,
/// a block that lost all contact, a block that has turned over by more than a given angle.
class EventWatch {
 public:
  explicit EventWatch(const BlockSystem& system);

  /// After a step; `frame` holds the contacts of that step.
  void look(const Simulation& simulation, const std::vector<ContactSample>& contacts);
  /// In order of time.
  std::vector<Event> events() const;

 private:
  /// Something that may be closed, and since when it is not.
  struct Watched {
    std::string what;
    bool was_closed = false, closed_now = false, told = false;
    double open_since = 0;
  };
  void settle(Watched& watched, double time);

  const BlockSystem& system_;
  std::map<std::pair<std::pair<int, int>, int>, Watched> joints_;  ///< by pair of blocks and joint
  std::vector<Watched> blocks_;
  std::vector<bool> turned_;
  std::vector<Event> events_;
};

}  // namespace talus
