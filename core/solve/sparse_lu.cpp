#include "solve/sparse_lu.hpp"

#include <cblas.h>
#include <umfpack.h>

#include <array>

namespace talus {

namespace {

std::array<double, UMFPACK_CONTROL> nearly_symmetric() {
  std::array<double, UMFPACK_CONTROL> control{};
  umfpack_di_defaults(control.data());
  control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
  control[UMFPACK_IRSTEP] = 0;
  return control;
}

}  // namespace

/// Threads of the BLAS below would change bits with their number.
SparseLu::SparseLu() { openblas_set_num_threads(1); }

SparseLu::~SparseLu() {
  forget_factor();
  forget_analysis();
}

void SparseLu::forget_analysis() {
  if (analysis_) umfpack_di_free_symbolic(&analysis_);
}

void SparseLu::forget_factor() {
  if (factor_) umfpack_di_free_numeric(&factor_);
}

void SparseLu::set_pattern(const BlockPattern& pattern) {
  if (pattern == pattern_) return;
  forget_factor();
  forget_analysis();
  pattern_ = pattern;
  size_ = 3 * pattern.nodes();
  // Of each node those that it is coupled to: first those before it, then itself and those behind it, all ascending.
  std::vector<std::vector<int>> coupled(pattern.nodes());
  below_.assign(pattern.slots(), 0);
  above_.assign(pattern.slots(), 0);
  for (int column = 0; column < pattern.nodes(); ++column)
    for (int slot = pattern.column_begin()[column]; slot < pattern.column_begin()[column + 1]; ++slot) {
      const int row = pattern.rows()[slot];
      if (row == column) continue;
      above_[slot] = 3 * static_cast<int>(coupled[row].size());
      coupled[row].push_back(column);
    }
  column_begin_.assign(1, 0);
  rows_.clear();
  heights_.clear();
  for (int column = 0; column < pattern.nodes(); ++column) {
    for (int slot = pattern.column_begin()[column]; slot < pattern.column_begin()[column + 1]; ++slot) {
      below_[slot] = column_begin_.back() + 3 * static_cast<int>(coupled[column].size());
      coupled[column].push_back(pattern.rows()[slot]);
    }
    heights_.push_back(3 * static_cast<int>(coupled[column].size()));
    for (int c = 0; c < 3; ++c) {
      for (const int row : coupled[column])
        for (int r = 0; r < 3; ++r) rows_.push_back(3 * row + r);
      column_begin_.push_back(static_cast<int>(rows_.size()));
    }
  }
  for (int slot = 0; slot < pattern.slots(); ++slot) above_[slot] += column_begin_[3 * pattern.rows()[slot]];
  values_.resize(rows_.size());
}

void SparseLu::add(int place, int column, const Mat3& block) {
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) values_[place + c * heights_[column] + r] += block(r, c);
}

bool SparseLu::factor(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> beyond) {
  values_.assign(values_.size(), 0);
  const auto add_both = [&](int slot, int row, int column, const Mat3& below, const Mat3& above) {
    add(below_[slot], column, below);
    if (row != column) add(above_[slot], row, above);
  };
  for (int column = 0; column < pattern_.nodes(); ++column)
    for (int slot = pattern_.column_begin()[column]; slot < pattern_.column_begin()[column + 1]; ++slot)
      add_both(slot, pattern_.rows()[slot], column, matrix.value(slot), matrix.value(slot).transpose());
  for (const UnsymmetricBlocks::Pair& pair : beyond)
    add_both(pattern_.slot(pair.row, pair.column), pair.row, pair.column, pair.below, pair.above);
  const auto control = nearly_symmetric();
  const int *columns = column_begin_.data(), *rows = rows_.data();
  if (!analysis_) umfpack_di_symbolic(size_, size_, columns, rows, values_.data(), &analysis_, control.data(), nullptr);
  forget_factor();
  return umfpack_di_numeric(columns, rows, values_.data(), analysis_, &factor_, control.data(), nullptr) == UMFPACK_OK;
}

void SparseLu::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  const auto control = nearly_symmetric();
  x.resize(size_);
  umfpack_di_solve(UMFPACK_A, column_begin_.data(), rows_.data(), values_.data(), x.data(), b.data(), factor_,
                   control.data(), nullptr);
}

}  // namespace talus
