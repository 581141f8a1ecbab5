#include "linear/tangent_rows.hpp"

#include <functional>
#include <numeric>

#include "base/parallel.hpp"

namespace talus {

namespace {

constexpr int rows_worth_a_thread = 1000;

}  // namespace

void TangentRows::set(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric) {
  const BlockPattern& pattern = matrix.pattern();
  const std::vector<int>&begin = pattern.column_begin(), &rows = pattern.rows();
  pair_of_.assign(pattern.slots(), -1);
  for (std::size_t p = 0; p < unsymmetric.size(); ++p)
    pair_of_[pattern.slot(unsymmetric[p].row, unsymmetric[p].column)] = static_cast<int>(p);
  const auto each = [&](const auto& use) {
    for (int column = 0; column < pattern.nodes(); ++column)
      for (int slot = begin[column]; slot < begin[column + 1]; ++slot)
        if (pair_of_[slot] >= 0 || !matrix.value(slot).isZero(0)) use(slot, rows[slot], column);
  };
  row_begin_.assign(pattern.nodes() + 1, 0);
  each([&](int, int row, int column) {
    ++row_begin_[row];
    if (row != column) ++row_begin_[column];
  });
  std::partial_sum(row_begin_.begin(), row_begin_.end(), row_begin_.begin());  // where each row ends
  blocks_.resize(row_begin_.back());
  each([&](int slot, int row, int column) {
    const UnsymmetricBlocks::Pair* const pair = pair_of_[slot] >= 0 ? &unsymmetric[pair_of_[slot]] : nullptr;
    Block& below = blocks_[--row_begin_[row]];
    below.column = column;
    below.value = matrix.value(slot);
    if (pair) below.value += pair->below;
    if (row == column) return;
    Block& above = blocks_[--row_begin_[column]];
    above.column = row;
    above.value = matrix.value(slot).transpose();
    if (pair) above.value += pair->above;
  });
}

void TangentRows::multiply(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  y.resize(x.size());
  const auto multiply_rows = [&](int first, int last) {
    for (int row = first; row < last; ++row) {
      Vec3 sum = Vec3::Zero();
      for (int k = row_begin_[row]; k < row_begin_[row + 1]; ++k)
        sum += blocks_[k].value * x.segment<3>(3 * blocks_[k].column);
      y.segment<3>(3 * row) = sum;
    }
  };
  in_parallel(static_cast<int>(row_begin_.size()) - 1, rows_worth_a_thread, std::ref(multiply_rows));
}

}  // namespace talus
