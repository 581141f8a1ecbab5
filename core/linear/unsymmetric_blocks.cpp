#include "linear/unsymmetric_blocks.hpp"

#include <algorithm>

namespace talus {

void UnsymmetricBlocks::set_pattern(const BlockPattern& pattern) {
  pattern_ = pattern;
  pair_.assign(pattern.slots(), -1);
  slots_.clear();
  pairs_.clear();
}

void UnsymmetricBlocks::set_zero() {
  for (const int slot : slots_) pair_[slot] = -1;
  slots_.clear();
  pairs_.clear();
}

void UnsymmetricBlocks::make_room(int slot, int i, int j) {
  if (pair_[slot] >= 0) return;
  pair_[slot] = static_cast<int>(pairs_.size());
  slots_.push_back(slot);
  pairs_.push_back({std::max(i, j), std::min(i, j), Mat3::Zero(), Mat3::Zero()});
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
