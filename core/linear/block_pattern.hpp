#pragma once

#include <span>
#include <utility>
#include <vector>

namespace talus {

/// Which 3×3 blocks of a symmetric pattern may differ from zero: its lower triangle, column by column, each block with
/// a slot of its own.
class BlockPattern {
 public:
  BlockPattern() = default;
  /// `couplings`: pairs of nodes in any order, as often as they come; the diagonal is always there.
  BlockPattern(int nodes, std::vector<std::pair<int, int>> couplings);

  /// The pattern of some nodes among themselves, in ascending order; they are coupled to no others. `local`: the
  /// number that each of them gets, by its number here.
  BlockPattern part(std::span<const int> nodes, std::span<const int> local) const;

  /// The nodes of each connected part, ascending; the parts by their first nodes.
  std::vector<std::vector<int>> connected_parts() const;

  int nodes() const { return static_cast<int>(column_begin_.size()) - 1; }
  int slots() const { return static_cast<int>(rows_.size()); }
  /// Slot of a pair of coupled nodes, in whichever order.
  int slot(int i, int j) const;
  const std::vector<int>& column_begin() const { return column_begin_; }
  const std::vector<int>& rows() const { return rows_; }
  bool operator==(const BlockPattern&) const = default;

 private:
  std::vector<int> column_begin_{0};
  std::vector<int> rows_;  ///< ascending in each column, the diagonal first
};

}  // namespace talus
