#pragma once

#include <optional>
#include <vector>

#include "model/quantity.hpp"
#include "results/monitor_value.hpp"
#include "results/run_report.hpp"

namespace talus {

struct BlockSystem;

class Simulation;

/// Follows the quantities that a project expects and compares them at their times, by linear interpolation between
/// steps.
class ExpectationWatch {
 public:
  ExpectationWatch(const Project& project, const BlockSystem& system);

  /// At the start of the run and after every step, with the history of that moment.
  void look(const Simulation& simulation, const HistoryRow& row);
  std::vector<ExpectationOutcome> outcomes() const;

  /// What it remembers from step to step.
  void archive(auto& state) { state(watched_, last_time_); }

 private:
  struct Watched {
    Expectation expectation;
    Quantity quantity;
    int monitor = -1, block = -1;  ///< one of them is given
    FieldValue last;
    std::optional<FieldValue> start, end;

    void archive(auto& state) { state(last, start, end); }
  };
  void follow(Watched& watched, const FieldValue& value, double time);

  std::vector<Watched> watched_;
  double last_time_ = 0;
};

}  // namespace talus
