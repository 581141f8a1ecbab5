#include "linear/symmetric_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace talus {

void SymmetricBlocks::set_pattern(BlockPattern pattern) {
  pattern_ = std::move(pattern);
  values_.assign(pattern_.slots(), Mat3::Zero());
}

void SymmetricBlocks::set_zero() { std::fill(values_.begin(), values_.end(), Mat3::Zero()); }

bool SymmetricBlocks::assign_part(const SymmetricBlocks& whole, std::span<const int> nodes) {
  const std::vector<int>& begin = whole.pattern_.column_begin();
  Mat3* to = values_.data();
  bool changed = false;
  for (const int node : nodes) {
    const Mat3* from = whole.values_.data() + begin[node];
    const std::size_t count = static_cast<std::size_t>(begin[node + 1] - begin[node]);
    changed = changed || std::memcmp(to, from, count * sizeof(Mat3)) != 0;
    if (changed) std::copy_n(from, count, to);
    to += count;
  }
  return changed;
}

void SymmetricBlocks::assign_columns(const SymmetricBlocks& other, std::span<const int> columns) {
  const std::vector<int>& begin = pattern_.column_begin();
  for (const int column : columns)
    std::copy(other.values_.begin() + begin[column], other.values_.begin() + begin[column + 1],
              values_.begin() + begin[column]);
}

double SymmetricBlocks::diagonal_norm() const { return diagonal_norm(0, pattern_.nodes()); }

double SymmetricBlocks::diagonal_norm(int begin, int end) const {
  double squares = 0;
  for (int column = begin; column < end; ++column)
    squares += values_[pattern_.column_begin()[column]].diagonal().squaredNorm();
  return std::sqrt(squares);
}

void SymmetricBlocks::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  const std::vector<int>&begin = pattern_.column_begin(), &rows = pattern_.rows();
  y.setZero(3 * nodes());
  for (int column = 0; column < nodes(); ++column)
    for (int slot = begin[column]; slot < begin[column + 1]; ++slot) {
      const int row = rows[slot];
      y.segment<3>(3 * row) += values_[slot] * x.segment<3>(3 * column);
      if (row != column) y.segment<3>(3 * column) += values_[slot].transpose() * x.segment<3>(3 * row);
    }
}

}  // namespace talus
