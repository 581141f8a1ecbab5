#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/known_answers/support/scene.hpp"

namespace talus {

/// Follows the energy ledger of a run: whether it closes, and whether mechanical energy (what effects hold, less the
/// work of constraints, and with what time integration holds of it) ever grows. What dissipates and what time
/// integration eats for good may only become more.
class LedgerWatch {
 public:
  explicit LedgerWatch(const CaseScene& scene);

  /// After a step.
  void look(const EnergyLedger& ledger);
  /// Blocks are held or let go from the next step on: what they hold moves between accounts, which is no growth.
  void holds_change() { dissipated_ = -std::numeric_limits<double>::infinity(); }

  double moved() const { return moved_; }          ///< J, the most that any account came to
  double remainder() const { return remainder_; }  ///< J, of the last step
  double growth() const { return growth_; }  ///< J, the most that mechanical energy ever lay above an earlier value
  /// Within 1e-8 of the energy moved, or, where blocks hardly move, within the rounding of positions.
  bool closes() const { return std::abs(remainder_) <= std::max(1e-8 * moved_, steps_ * rounding_); }
  /// Beyond `share` of the energy moved and the rounding of positions.
  bool grows(double share) const { return growth_ > std::max(share * moved_, steps_ * rounding_); }

 private:
  double moved_ = 0, remainder_ = 0, growth_ = 0;  // J
  double rounding_ = 0;                            // J a step: of positions, times weights
  double dissipated_ = 0;                          // J, the most so far
  int steps_ = 0;
};

}  // namespace talus
