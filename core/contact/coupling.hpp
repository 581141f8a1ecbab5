#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contact/contact_points.hpp"

namespace talus {

/// Plans which nodes contacts may couple: those of their stencils, and the nodes around them on the same patches, where
/// the contacts may slide to. The plan stays until a contact needs a pair that it lacks.
class Coupling {
 public:
  explicit Coupling(const ContactFeatures& features) : features_(features) {}

  /// Makes sure that the plan holds what these points couple.
  void cover(const FoundPoints& found);

  /// Forgets the plan: other nodes may move.
  void clear();

  const std::vector<std::pair<int, int>>& pairs() const { return pairs_; }
  std::uint64_t generation() const { return generation_; }

 private:
  bool holds(int i, int j) const;
  bool holds(const FoundPoints& found) const;
  void widen(std::span<const int> nodes, int patch, std::vector<int>& widened) const;

  const ContactFeatures& features_;
  std::vector<std::pair<int, int>> pairs_;  // sorted
  std::vector<int> row_begin_;              // by first node
  std::uint64_t generation_ = 0;
};

}  // namespace talus
