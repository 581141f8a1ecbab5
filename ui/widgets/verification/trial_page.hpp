#pragma once

#include "verification/hard_cases/trial.hpp"
#include "widgets/verification/outcome_page.hpp"

namespace talus {

/// One hard case: where it comes from, what it must come to, and what the last run of it came to.
class TrialPage : public OutcomePage {
  Q_OBJECT
 public:
  /// `trial` may be null: not run yet.
  void show(const HardCase& hardCase, const Trial* trial);

 private:
  void addFaults(const Trial& trial);
  void addFigures(const Trial& trial);
};

}  // namespace talus
