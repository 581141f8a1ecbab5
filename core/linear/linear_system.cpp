#include "linear/linear_system.hpp"

#include <algorithm>
#include <functional>

#include "base/parallel.hpp"

namespace talus {

namespace {

constexpr int pairs_worth_a_thread = 1000;

}  // namespace

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

void LinearSystem::hand_out(std::span<const UnsymmetricBlocks::Pair> pairs) {
  places_.resize(pairs.size());
  counts_.assign(systems_.size(), 0);
  for (std::size_t p = 0; p < pairs.size(); ++p) places_[p] = counts_[system_of_[pairs[p].row]]++;
  for (std::size_t s = 0; s < systems_.size(); ++s) systems_[s].expect_unsymmetric(counts_[s]);
  const auto hand_out_some = [&](int first, int last) {
    for (int p = first; p < last; ++p) {
      const auto& [row, column, below, above] = pairs[p];
      systems_[system_of_[row]].take_unsymmetric(places_[p],
                                                 {number_in_system_[row], number_in_system_[column], below, above});
    }
  };
  in_parallel(static_cast<int>(pairs.size()), pairs_worth_a_thread, std::ref(hand_out_some));
}

void LinearSystem::solve(const SymmetricBlocks& matrix, const UnsymmetricBlocks& unsymmetric, const Eigen::VectorXd& b,
                         std::span<const double> negligible, Eigen::VectorXd& x) {
  x.setZero(b.size());
  sizes_.resize(systems_.size());
  for (std::size_t s = 0; s < systems_.size(); ++s) sizes_[s] = systems_[s].take_right_side(b);
  hand_out(unsymmetric.pairs());
  for (std::size_t s = 0; s < systems_.size(); ++s) {
    const double nothing = negligible.empty() ? 0 : negligible[s];
    if (sizes_[s] > nothing) systems_[s].solve(matrix, settings_, nothing, trials_, work_, x);
  }
}

}  // namespace talus
