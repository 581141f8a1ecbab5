#pragma once

#include <vector>

#include "bodies/block_motion.hpp"
#include "effects/compose.hpp"

namespace talus {

/// Cauchy stress of bodies [Pa], asked of the effects whenever somebody wants to see it.
class StressRecovery {
 public:
  /// Both outlive it.
  StressRecovery(const BodySet& bodies, const Composition& composition) : bodies_(bodies), composition_(composition) {}

  /// Of all elements that move, an entry each.
  std::vector<Voigt> all() const;
  /// Of a body's own elements, from those of all that move.
  std::vector<Voigt> of_body(int body, const std::vector<Voigt>& all) const;
  Voigt at(const MaterialPoint& point, const std::vector<Voigt>& all) const;

  long count() const { return count_; }  ///< bodies whose stress was computed

  /// What it has done so far.
  void archive(auto& state) { state(count_); }

 private:
  const BodySet& bodies_;
  const Composition& composition_;
  mutable long count_ = 0;  // looking at stress is counted, and changes nothing
};

}  // namespace talus
