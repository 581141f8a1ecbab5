#pragma once

#include <span>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "linear/symmetric_blocks.hpp"
#include "linear/unsymmetric_blocks.hpp"

namespace talus {

/// Which nodes of a matrix couple now: the pattern knows of all contacts that may close, the values of those that are
/// closed. Allocates at the first of a size only.
class CoupledParts {
 public:
  /// Looks at what is not zero.
  void find(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric);

  int count() const { return static_cast<int>(begin_.size()) - 1; }
  /// Ascending; parts come by their first nodes.
  std::span<const int> nodes(int part) const {
    return std::span(nodes_).subspan(begin_[part], begin_[part + 1] - begin_[part]);
  }
  /// Pairs of its nodes with a value in the symmetric matrix.
  int couplings(int part) const { return couplings_[part]; }

 private:
  DisjointSets together_;
  std::vector<char> has_value_;  // a slot: whether it holds anything but zeros
  std::vector<int> part_of_, number_of_, begin_, nodes_, couplings_;
};

}  // namespace talus
