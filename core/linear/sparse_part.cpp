#include "linear/sparse_part.hpp"

#include <utility>

#include "linear/not_positive_definite.hpp"

namespace talus {

void SparsePart::factor(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric,
                        const CoupledParts& parts, int part) {
  const std::span<const int> nodes = parts.nodes(part);
  number_.resize(matrix.nodes());
  for (std::size_t k = 0; k < nodes.size(); ++k) number_[nodes[k]] = static_cast<int>(k);
  const auto has_value = [&](int slot) { return parts.has_value(slot); };
  BlockPattern pattern = matrix.pattern().part(nodes, number_, has_value);
  if (pattern != matrix_.pattern()) {
    factor_.analyse(pattern);
    matrix_.set_pattern(std::move(pattern));
  }
  const std::vector<int>& begin = matrix.pattern().column_begin();
  matrix_.set_zero();
  int to = 0;
  for (const int column : nodes)
    for (int slot = begin[column]; slot < begin[column + 1]; ++slot)
      if (slot == begin[column] || has_value(slot)) matrix_.add_at(to++, matrix.value(slot));
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
