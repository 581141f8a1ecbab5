#include "linear/unsymmetric_blocks.hpp"

#include <algorithm>
#include <functional>

#include "base/parallel.hpp"

namespace talus {

namespace {

constexpr int zeros_worth_a_thread = 1000;

}  // namespace

void UnsymmetricBlocks::set_pattern(const BlockPattern& pattern) {
  pattern_ = pattern;
  pair_.assign(pattern.slots(), -1);
  slots_.clear();
  pairs_.clear();
}

void UnsymmetricBlocks::set_zero() {
  for (const int slot : slots_) pair_[slot] = -1;
  const auto set_some_zero = [this](int first, int last) {
    for (int i = first; i < last; ++i) pairs_[i] = {0, 0, Mat3::Zero(), Mat3::Zero()};
  };
  in_parallel(static_cast<int>(slots_.size()), zeros_worth_a_thread, std::ref(set_some_zero));
  slots_.clear();
}

void UnsymmetricBlocks::make_room(int slot, int i, int j) {
  if (pair_[slot] >= 0) return;
  const std::size_t next = slots_.size();
  pair_[slot] = static_cast<int>(next);
  slots_.push_back(slot);
  if (next == pairs_.size()) pairs_.push_back({0, 0, Mat3::Zero(), Mat3::Zero()});
  pairs_[next].row = std::max(i, j);
  pairs_[next].column = std::min(i, j);
}

void UnsymmetricBlocks::add_at(int slot, int i, int j, const Mat3& block) {
  make_room(slot, i, j);
  Pair& pair = pairs_[pair_[slot]];
  (i >= j ? pair.below : pair.above) += block;
}

void UnsymmetricBlocks::add_product(std::span<const Pair> pairs, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
  for (const Pair& pair : pairs) {
    y.segment<3>(3 * pair.row) += pair.below * x.segment<3>(3 * pair.column);
    if (pair.row != pair.column) y.segment<3>(3 * pair.column) += pair.above * x.segment<3>(3 * pair.row);
  }
}

}  // namespace talus
