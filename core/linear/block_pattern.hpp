#pragma once

#include <cstdint>
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

  /// The pattern of some nodes among themselves, in ascending order. `local`: the number that each of them gets, by its
  /// number here. Of all slots beside the diagonal those that `are_kept`, none of them with another node.
  template <class AreKept>
  BlockPattern part(std::span<const int> nodes, std::span<const int> local, const AreKept& are_kept) const {
    BlockPattern part;
    part.id_ = new_id();
    for (const int node : nodes) {
      for (int slot = column_begin_[node]; slot < column_begin_[node + 1]; ++slot)
        if (slot == column_begin_[node] || are_kept(slot)) part.rows_.push_back(local[rows_[slot]]);
      part.column_begin_.push_back(static_cast<int>(part.rows_.size()));
    }
    return part;
  }
  BlockPattern part(std::span<const int> nodes, std::span<const int> local) const {
    return part(nodes, local, [](int) { return true; });
  }

  /// The nodes of each connected part, ascending; the parts by their first nodes.
  std::vector<std::vector<int>> connected_parts() const;

  int nodes() const { return static_cast<int>(column_begin_.size()) - 1; }
  int slots() const { return static_cast<int>(rows_.size()); }
  /// Slot of a pair of coupled nodes, in whichever order.
  int slot(int i, int j) const;
  const std::vector<int>& column_begin() const { return column_begin_; }
  const std::vector<int>& rows() const { return rows_; }
  /// The same for a pattern and its copies, and for no other: who keeps slots can tell whether they still hold. 0: it
  /// is empty.
  std::uint64_t id() const { return id_; }
  bool operator==(const BlockPattern& other) const {
    return column_begin_ == other.column_begin_ && rows_ == other.rows_;
  }

  void archive(auto& state) {
    state(column_begin_, rows_);
    if (state.reads()) id_ = new_id();
  }

 private:
  static std::uint64_t new_id();
  std::uint64_t id_ = 0;
  std::vector<int> column_begin_{0};
  std::vector<int> rows_;  ///< ascending in each column, the diagonal first
};

}  // namespace talus
