#include "linear/cholesky.hpp"

#include <cblas.h>
#include <cholmod.h>
#include <omp.h>

#include <algorithm>

namespace talus {

struct Cholesky::State {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_dense *solution = nullptr, *work_y = nullptr, *work_e = nullptr;
  std::vector<int> column_begin, rows;  ///< scalar lower triangle, column by column
  std::vector<double> values;
  bool has_values = false;  ///< those of a matrix that was factored

  State() {
    cholmod_start(&common);
    common.print = 0;
    common.error_handler = nullptr;
    common.final_ll = 1;  // LDLᵀ, the default for small matrices, would go on through an indefinite one
    // Threads cost more than they bring on fronts of this size, and would change bits with their number. CHOLMOD asks
    // OpenMP for four of its own whatever the machine has; with no active level each region runs on its caller.
    omp_set_max_active_levels(0);
    openblas_set_num_threads(1);
  }
  ~State() {
    cholmod_free_factor(&factor, &common);
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&work_y, &common);
    cholmod_free_dense(&work_e, &common);
    cholmod_finish(&common);
  }

  cholmod_sparse sparse() {
    cholmod_sparse matrix{};
    matrix.nrow = matrix.ncol = column_begin.size() - 1;
    matrix.nzmax = rows.size();
    matrix.p = column_begin.data();
    matrix.i = rows.data();
    matrix.x = values.data();
    matrix.stype = -1;
    matrix.itype = CHOLMOD_INT;
    matrix.xtype = CHOLMOD_REAL;
    matrix.dtype = CHOLMOD_DOUBLE;
    matrix.sorted = matrix.packed = 1;
    return matrix;
  }

  /// An order of the nodes that fills little in: a third as many as there are unknowns, which come in the same order.
  std::vector<int> order_of(const BlockPattern& pattern) {
    cholmod_sparse nodes{};
    nodes.nrow = nodes.ncol = static_cast<std::size_t>(pattern.nodes());
    nodes.nzmax = pattern.rows().size();
    nodes.p = const_cast<int*>(pattern.column_begin().data());  // CHOLMOD reads them only
    nodes.i = const_cast<int*>(pattern.rows().data());
    nodes.stype = -1;
    nodes.itype = CHOLMOD_INT;
    nodes.xtype = CHOLMOD_PATTERN;
    nodes.sorted = nodes.packed = 1;
    common.nmethods = 0;  // minimum degree, and nested dissection where that fills too much in
    cholmod_factor* analysed = cholmod_analyze(&nodes, &common);
    const int* order = static_cast<const int*>(analysed->Perm);
    std::vector<int> unknowns;
    for (int k = 0; k < pattern.nodes(); ++k)
      for (int c = 0; c < 3; ++c) unknowns.push_back(3 * order[k] + c);
    cholmod_free_factor(&analysed, &common);
    return unknowns;
  }

  void set_pattern(const BlockPattern& pattern) {
    column_begin.assign(1, 0);
    rows.clear();
    for (int column = 0; column < pattern.nodes(); ++column)
      for (int c = 0; c < 3; ++c) {
        for (int slot = pattern.column_begin()[column]; slot < pattern.column_begin()[column + 1]; ++slot)
          for (int r = pattern.rows()[slot] == column ? c : 0; r < 3; ++r) rows.push_back(3 * pattern.rows()[slot] + r);
        column_begin.push_back(static_cast<int>(rows.size()));
      }
    values.resize(rows.size());
    has_values = false;
  }

  void factorize() {
    cholmod_sparse matrix = sparse();
    cholmod_factorize(&matrix, factor, &common);
    has_values = true;
  }

  void set_values(const SymmetricBlocks& matrix) {
    const BlockPattern& pattern = matrix.pattern();
    std::size_t k = 0;
    for (int column = 0; column < pattern.nodes(); ++column)
      for (int c = 0; c < 3; ++c)
        for (int slot = pattern.column_begin()[column]; slot < pattern.column_begin()[column + 1]; ++slot)
          for (int r = pattern.rows()[slot] == column ? c : 0; r < 3; ++r) values[k++] = matrix.value(slot)(r, c);
  }
};

Cholesky::Cholesky() : state_(std::make_unique<State>()) {}
Cholesky::~Cholesky() = default;

void Cholesky::analyse(const BlockPattern& pattern) {
  cholmod_free_factor(&state_->factor, &state_->common);
  state_->set_pattern(pattern);
  std::vector<int> order = state_->order_of(pattern);
  cholmod_sparse sparse = state_->sparse();
  state_->common.nmethods = 1;
  state_->common.method[0].ordering = CHOLMOD_GIVEN;
  state_->factor = cholmod_analyze_p(&sparse, order.data(), nullptr, 0, &state_->common);
}

double Cholesky::flops() const { return state_->common.fl; }
double Cholesky::entries() const { return state_->common.lnz; }

void Cholesky::factor(const SymmetricBlocks& matrix) {
  state_->set_values(matrix);
  state_->factorize();
  const cholmod_factor& result = *state_->factor;
  if (state_->common.status == CHOLMOD_OK && result.minor == result.n) return;
  throw NotPositiveDefinite(static_cast<const int*>(result.Perm)[std::min(result.minor, result.n - 1)] / 3);
}

void Cholesky::archive(StateArchive& state) {
  state(state_->has_values, state_->values);
  if (state.reads() && state_->has_values) state_->factorize();
}

void Cholesky::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  cholmod_dense right{};
  right.nrow = right.nzmax = right.d = static_cast<std::size_t>(b.size());
  right.ncol = 1;
  right.x = const_cast<double*>(b.data());  // CHOLMOD reads it only
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  cholmod_solve2(CHOLMOD_A, state_->factor, &right, nullptr, &state_->solution, nullptr, &state_->work_y,
                 &state_->work_e, &state_->common);
  x = Eigen::Map<Eigen::VectorXd>(static_cast<double*>(state_->solution->x), b.size());
}

}  // namespace talus
