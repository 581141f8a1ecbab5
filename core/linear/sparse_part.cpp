#include "linear/sparse_part.hpp"

#include "linear/not_positive_definite.hpp"

namespace talus {

void SparsePart::factor(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric,
                        std::span<const int> nodes) {
  number_.resize(matrix.nodes());
  for (std::size_t k = 0; k < nodes.size(); ++k) number_[nodes[k]] = static_cast<int>(k);
  const BlockPattern& all = matrix.pattern();
  const auto each_value = [&](const auto& take) {
    for (const int column : nodes)
      for (int slot = all.column_begin()[column]; slot < all.column_begin()[column + 1]; ++slot)
        if (!matrix.value(slot).isZero(0)) take(number_[all.rows()[slot]], number_[column], matrix.value(slot));
  };
  couplings_.clear();
  each_value([&](int row, int column, const Mat3&) { couplings_.emplace_back(column, row); });
  BlockPattern pattern(static_cast<int>(nodes.size()), couplings_);
  if (pattern != matrix_.pattern()) {
    factor_.analyse(pattern);
    matrix_.set_pattern(std::move(pattern));
  }
  matrix_.set_zero();
  each_value([&](int row, int column, const Mat3& value) { matrix_.add(row, column, value); });
  unsymmetric_.clear();
  for (const UnsymmetricBlocks::Pair& pair : unsymmetric) {
    const auto k = static_cast<std::size_t>(number_[pair.row]);
    if (k < nodes.size() && nodes[k] == pair.row)
      unsymmetric_.push_back({number_[pair.row], number_[pair.column], pair.below, pair.above});
  }
  try {
    factor_.factor(matrix_);
  } catch (const NotPositiveDefinite& error) {
    throw NotPositiveDefinite(nodes[error.node]);
  }
}

int SparsePart::solve(const Eigen::VectorXd& b, const LinearSettings& settings, Eigen::VectorXd& x) {
  if (!unsymmetric_.empty()) return factor_.solve(matrix_, unsymmetric_, b, settings, x);
  factor_.solve(b, x);
  return 0;
}

}  // namespace talus
