#include "linear/block_pattern.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>

#include "base/disjoint_sets.hpp"

namespace talus {

std::uint64_t BlockPattern::new_id() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

BlockPattern::BlockPattern(int nodes, std::vector<std::pair<int, int>> couplings)
    : id_(new_id()), column_begin_(nodes + 1, 0) {
  for (auto& [column, row] : couplings)
    if (column > row) std::swap(column, row);
  for (int i = 0; i < nodes; ++i) couplings.emplace_back(i, i);
  std::sort(couplings.begin(), couplings.end());
  couplings.erase(std::unique(couplings.begin(), couplings.end()), couplings.end());
  rows_.reserve(couplings.size());
  for (const auto& [column, row] : couplings) {
    ++column_begin_[column + 1];
    rows_.push_back(row);
  }
  for (int i = 0; i < nodes; ++i) column_begin_[i + 1] += column_begin_[i];
}

std::vector<std::vector<int>> BlockPattern::connected_parts() const {
  DisjointSets sets;
  sets.reset(nodes());
  for (int column = 0; column < nodes(); ++column)
    for (int slot = column_begin_[column]; slot < column_begin_[column + 1]; ++slot) sets.join(column, rows_[slot]);
  std::vector<std::vector<int>> parts;
  std::vector<int> part_of(nodes());
  for (int node = 0; node < nodes(); ++node) {
    const int first = sets.first_of(node);
    if (first == node) {
      part_of[node] = static_cast<int>(parts.size());
      parts.emplace_back();
    }
    parts[part_of[first]].push_back(node);
  }
  return parts;
}

int BlockPattern::slot(int i, int j) const {
  const auto [column, row] = std::minmax(i, j);
  const int first = column_begin_[column];
  if (row == column) return first;
  const auto begin = rows_.begin() + first + 1, end = rows_.begin() + column_begin_[column + 1];
  const auto found = std::lower_bound(begin, end, row);
  assert(found != end && *found == row && "an effect couples nodes that it did not announce");
  return static_cast<int>(found - rows_.begin());
}

}  // namespace talus
