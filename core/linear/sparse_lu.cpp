#include "linear/sparse_lu.hpp"

#include <cblas.h>
#include <umfpack.h>

#include <array>
#include <utility>

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

void SparseLu::lay_out() {
  forget_factor();
  forget_analysis();
  const int nodes = pattern_.nodes();
  const auto each_present = [this, nodes](const auto& visit) {
    for (int column = 0; column < nodes; ++column)
      for (int slot = pattern_.column_begin()[column]; slot < pattern_.column_begin()[column + 1]; ++slot)
        if (present_[slot]) visit(slot, pattern_.rows()[slot], column);
  };
  // Of each node those that it is coupled to, ascending: those before it, then itself and those behind it.
  std::vector<std::vector<int>> coupled(nodes);
  below_.assign(present_.size(), 0);
  above_.assign(present_.size(), 0);
  each_present([&](int slot, int row, int column) {
    if (row == column) return;
    above_[slot] = 3 * static_cast<int>(coupled[row].size());
    coupled[row].push_back(column);
  });
  each_present([&](int slot, int row, int column) {
    below_[slot] = 3 * static_cast<int>(coupled[column].size());
    coupled[column].push_back(row);
  });
  column_begin_.assign(1, 0);
  rows_.clear();
  heights_.clear();
  for (int column = 0; column < nodes; ++column) {
    heights_.push_back(3 * static_cast<int>(coupled[column].size()));
    for (int c = 0; c < 3; ++c) {
      for (const int row : coupled[column])
        for (int r = 0; r < 3; ++r) rows_.push_back(3 * row + r);
      column_begin_.push_back(static_cast<int>(rows_.size()));
    }
  }
  each_present([&](int slot, int row, int column) {
    below_[slot] += column_begin_[3 * column];
    above_[slot] += column_begin_[3 * row];
  });
  values_.resize(rows_.size());
}

void SparseLu::add(int place, int column, const Mat3& block) {
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) values_[place + c * heights_[column] + r] += block(r, c);
}

bool SparseLu::factor(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric) {
  bool more = matrix.pattern() != pattern_;
  if (more) {
    pattern_ = matrix.pattern();
    present_.assign(pattern_.slots(), 0);
  }
  const auto mark = [&](int slot) { more = !std::exchange(present_[slot], 1) || more; };
  for (int slot = 0; slot < pattern_.slots(); ++slot)
    if (!matrix.value(slot).isZero(0)) mark(slot);
  for (const UnsymmetricBlocks::Pair& pair : unsymmetric) mark(pattern_.slot(pair.row, pair.column));
  if (more) lay_out();
  values_.assign(values_.size(), 0);
  const auto add_both = [&](int slot, int row, int column, const Mat3& below, const Mat3& above) {
    add(below_[slot], column, below);
    if (row != column) add(above_[slot], row, above);
  };
  for (int column = 0; column < pattern_.nodes(); ++column)
    for (int slot = pattern_.column_begin()[column]; slot < pattern_.column_begin()[column + 1]; ++slot)
      if (present_[slot])
        add_both(slot, pattern_.rows()[slot], column, matrix.value(slot), matrix.value(slot).transpose());
  for (const UnsymmetricBlocks::Pair& pair : unsymmetric)
    add_both(pattern_.slot(pair.row, pair.column), pair.row, pair.column, pair.below, pair.above);
  forget_factor();
  if (!analyse()) return false;
  const auto control = nearly_symmetric();
  return umfpack_di_numeric(column_begin_.data(), rows_.data(), values_.data(), analysis_, &factor_, control.data(),
                            nullptr) == UMFPACK_OK;
}

void SparseLu::archive(StateArchive& state) {
  state(pattern_, present_);
  if (state.reads()) lay_out();
}

bool SparseLu::analyse() {
  if (analysis_) return true;
  const auto control = nearly_symmetric();
  const int size = static_cast<int>(column_begin_.size()) - 1;
  const int status = umfpack_di_symbolic(size, size, column_begin_.data(), rows_.data(), values_.data(), &analysis_,
                                         control.data(), nullptr);
  if (status != UMFPACK_OK) forget_analysis();
  return status == UMFPACK_OK;
}

void SparseLu::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  const auto control = nearly_symmetric();
  x.resize(b.size());
  umfpack_di_solve(UMFPACK_A, column_begin_.data(), rows_.data(), values_.data(), x.data(), b.data(), factor_,
                   control.data(), nullptr);
}

}  // namespace talus
