#include "linear/sparse_part.hpp"

#include <utility>

#include "linear/not_positive_definite.hpp"

namespace talus {

void SparsePart::take(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric,
                      std::span<const int> nodes) {
  number_.resize(matrix.nodes());
  for (std::size_t k = 0; k < nodes.size(); ++k) number_[nodes[k]] = static_cast<int>(k);
  const auto has = [&](int node) {
    const auto k = static_cast<std::size_t>(number_[node]);
    return k < nodes.size() && nodes[k] == node;
  };
  const std::vector<int>& rows = matrix.pattern().rows();
  const auto is_kept = [&](int slot) { return has(rows[slot]) && !matrix.value(slot).isZero(0); };
  BlockPattern pattern = matrix.pattern().part(nodes, number_, is_kept);
  if (pattern != matrix_.pattern()) {
    matrix_.set_pattern(std::move(pattern));
    analysed_ = false;
  }
  const std::vector<int>& begin = matrix.pattern().column_begin();
  matrix_.set_zero();
  int to = 0;
  for (const int column : nodes)
    for (int slot = begin[column]; slot < begin[column + 1]; ++slot)
      if (slot == begin[column] || is_kept(slot)) matrix_.add_at(to++, matrix.value(slot));
  unsymmetric_.clear();
  for (const UnsymmetricBlocks::Pair& pair : unsymmetric)
    if (has(pair.row) && has(pair.column))
      unsymmetric_.push_back({number_[pair.row], number_[pair.column], pair.below, pair.above});
  nodes_.assign(nodes.begin(), nodes.end());
}

void SparsePart::factor() {
  if (!analysed_) factor_.analyse(matrix_.pattern());
  analysed_ = true;
  try {
    factor_.factor(matrix_);
  } catch (const NotPositiveDefinite& error) {
    throw NotPositiveDefinite(nodes_[error.node]);
  }
}

void SparsePart::solve(const Eigen::VectorXd& b, const LinearSettings& settings, LinearWork& work, Eigen::VectorXd& x) {
  if (incomplete_.solve(matrix_, unsymmetric_, b, settings, work, x)) return;
  factor();
  ++work.factorisations;
  if (unsymmetric_.empty()) return factor_.solve(b, x);
  const int iterations = factor_.solve(matrix_, unsymmetric_, b, settings, x);
  work.gmres_iterations += iterations;
  if (iterations >= settings.limit) ++work.gmres_limits;
}

}  // namespace talus
