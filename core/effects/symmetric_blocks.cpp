#include "effects/symmetric_blocks.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace talus {

void SymmetricBlocks::set_pattern(int nodes, std::vector<std::pair<int, int>> couplings) {
  for (auto& [column, row] : couplings)
    if (column > row) std::swap(column, row);
  for (int i = 0; i < nodes; ++i) couplings.emplace_back(i, i);
  std::sort(couplings.begin(), couplings.end());
  couplings.erase(std::unique(couplings.begin(), couplings.end()), couplings.end());
  column_begin_.assign(nodes + 1, 0);
  rows_.clear();
  rows_.reserve(couplings.size());
  for (const auto& [column, row] : couplings) {
    ++column_begin_[column + 1];
    rows_.push_back(row);
  }
  for (int i = 0; i < nodes; ++i) column_begin_[i + 1] += column_begin_[i];
  values_.assign(rows_.size(), Mat3::Zero());
}

void SymmetricBlocks::add(int i, int j, const Mat3& block) {
  const int column = std::min(i, j), row = std::max(i, j);
  const auto begin = rows_.begin() + column_begin_[column], end = rows_.begin() + column_begin_[column + 1];
  const auto found = std::lower_bound(begin, end, row);
  assert(found != end && *found == row && "an effect couples nodes that it did not announce");
  Mat3& value = values_[found - rows_.begin()];
  if (i >= j)
    value += weight_ * block;
  else
    value += weight_ * block.transpose();
}

void SymmetricBlocks::set_zero() { std::fill(values_.begin(), values_.end(), Mat3::Zero()); }

double SymmetricBlocks::diagonal_norm() const {
  double squares = 0;
  for (int column = 0; column < nodes(); ++column) squares += values_[column_begin_[column]].diagonal().squaredNorm();
  return std::sqrt(squares);
}

void SymmetricBlocks::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  y.setZero(3 * nodes());
  for (int column = 0; column < nodes(); ++column)
    for (int slot = column_begin_[column]; slot < column_begin_[column + 1]; ++slot) {
      const int row = rows_[slot];
      y.segment<3>(3 * row) += values_[slot] * x.segment<3>(3 * column);
      if (row != column) y.segment<3>(3 * column) += values_[slot].transpose() * x.segment<3>(3 * row);
    }
}

}  // namespace talus
