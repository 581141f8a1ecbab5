#include "linear/linear_system.hpp"

#include <algorithm>

namespace talus {

void LinearSystem::set_pattern(const BlockPattern& pattern) {
  pattern_ = pattern;
  std::vector<IndependentSystem> before = std::move(systems_);
  systems_.clear();
  system_of_.resize(pattern.nodes());
  number_in_system_.resize(pattern.nodes());
  work_.largest_system = 0;
  auto old = before.begin();
  for (std::vector<int>& nodes : pattern.connected_parts()) {
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

void LinearSystem::demand_factors() {
  for (IndependentSystem& system : systems_) system.demand_factor();
}

void LinearSystem::solve(const SymmetricBlocks& matrix, const UnsymmetricBlocks& unsymmetric, const Eigen::VectorXd& b,
                         std::span<const double> negligible, Eigen::VectorXd& x) {
  x.setZero(b.size());
  sizes_.resize(systems_.size());
  for (std::size_t s = 0; s < systems_.size(); ++s) sizes_[s] = systems_[s].take_right_side(b);
  for (const UnsymmetricBlocks::Pair& pair : unsymmetric.pairs())
    systems_[system_of_[pair.row]].take_unsymmetric(
        {number_in_system_[pair.row], number_in_system_[pair.column], pair.below, pair.above});
  for (std::size_t s = 0; s < systems_.size(); ++s) {
    const double nothing = negligible.empty() ? 0 : negligible[s];
    if (sizes_[s] > nothing) systems_[s].solve(matrix, settings_, nothing, trials_, work_, x);
  }
}

}  // namespace talus
