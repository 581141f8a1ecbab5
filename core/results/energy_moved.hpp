#pragma once

#include <algorithm>
#include <cmath>

#include "results/run_report.hpp"

namespace talus {

/// J, the largest account of a ledger. The most that it came to since a run began is the energy that moved, to which
/// remainder, growth and losses are held.
inline double largest_account(const EnergyLedger& e) {
  double largest = 0;
  for (const double energy : {e.kinetic, e.elastic, e.potential, e.contact, e.friction_dissipated, e.damping_dissipated,
                              e.constraint_work, e.integration_loss})
    largest = std::max(largest, std::abs(energy));
  return largest;
}

}  // namespace talus
