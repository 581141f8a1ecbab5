#include "linear/linear_system.hpp"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.hpp"

namespace talus {

namespace {

/// The nodes of each connected part of a pattern, ascending; the parts by their first nodes.
std::vector<std::vector<int>> connected_parts(const BlockPattern& pattern) {
  DisjointSets sets;
  sets.reset(pattern.nodes());
  for (int column = 0; column < pattern.nodes(); ++column)
    for (int slot = pattern.column_begin()[column]; slot < pattern.column_begin()[column + 1]; ++slot)
      sets.join(column, pattern.rows()[slot]);
  std::vector<std::vector<int>> parts;
  std::vector<int> part_of(pattern.nodes());
  for (int node = 0; node < pattern.nodes(); ++node) {
    const int first = sets.first_of(node);
    if (first == node) {
      part_of[node] = static_cast<int>(parts.size());
      parts.emplace_back();
    }
    parts[part_of[first]].push_back(node);
  }
  return parts;
}

}  // namespace

void LinearSystem::set_pattern(const BlockPattern& pattern) {
  std::vector<IndependentSystem> before = std::move(systems_);
  systems_.clear();
  system_of_.resize(pattern.nodes());
  number_in_system_.resize(pattern.nodes());
  work_.largest_system = 0;
  auto old = before.begin();
  for (std::vector<int>& nodes : connected_parts(pattern)) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      system_of_[nodes[i]] = static_cast<int>(systems_.size());
      number_in_system_[nodes[i]] = static_cast<int>(i);
    }
    BlockPattern part = pattern.part(nodes, number_in_system_);
    work_.largest_system = std::max(work_.largest_system, static_cast<int>(nodes.size()));
    while (old != before.end() && old->first_node() < nodes.front()) ++old;
    if (old != before.end() && old->is_of(nodes, part))
      systems_.push_back(std::move(*old++));
    else
      systems_.emplace_back(std::move(nodes), std::move(part));
  }
  work_.systems = static_cast<int>(systems_.size());
}

void LinearSystem::outdate() {
  for (IndependentSystem& system : systems_) system.outdate();
}

void LinearSystem::solve(const SymmetricBlocks& matrix, const UnsymmetricBlocks& unsymmetric, const Eigen::VectorXd& b,
                         double negligible, Eigen::VectorXd& x) {
  x.setZero(b.size());
  sizes_.resize(systems_.size());
  for (std::size_t s = 0; s < systems_.size(); ++s) sizes_[s] = systems_[s].take_right_side(b);
  for (const UnsymmetricBlocks::Pair& pair : unsymmetric.pairs())
    systems_[system_of_[pair.row]].take_unsymmetric(
        {number_in_system_[pair.row], number_in_system_[pair.column], pair.below, pair.above});
  const double negligible_part = negligible / std::sqrt(static_cast<double>(systems_.size()));
  for (std::size_t s = 0; s < systems_.size(); ++s)
    if (sizes_[s] > negligible_part) systems_[s].solve(matrix, settings_, negligible_part, work_, x);
}

}  // namespace talus
