#include "solve/independent_system.hpp"

#include <algorithm>

#include "solve/not_positive_definite.hpp"
#include "solve/stopwatch.hpp"

namespace talus {

IndependentSystem::IndependentSystem(std::vector<int> nodes, BlockPattern pattern) : nodes_(std::move(nodes)) {
  matrix_.set_pattern(std::move(pattern));
  right_.resize(3 * size());
  if (3 * size() <= DenseSolver::largest) return;
  sparse_ = std::make_unique<Sparse>();
  sparse_->cholesky.analyse(matrix_.pattern());
  // A solve with a factor touches each of its entries twice; what a factor costs beside it, at the rates of one core.
  constexpr double factor_rate = 20e9, solve_rate = 10e9;
  const Cholesky& cholesky = sparse_->cholesky;
  sparse_->patience =
      std::clamp(static_cast<int>(cholesky.flops() / factor_rate / (16 * cholesky.entries() / solve_rate)), 5, 30);
}

double IndependentSystem::take_right_side(const Eigen::VectorXd& b) {
  for (int i = 0; i < size(); ++i) right_.segment<3>(3 * i) = b.segment<3>(3 * nodes_[i]);
  beyond_.clear();
  return right_.norm();
}

void IndependentSystem::solve(const SymmetricBlocks& whole, const LinearSettings& settings, LinearWork& work,
                              Eigen::VectorXd& x) {
  if (matrix_.assign_part(whole, nodes_)) current_ = false;
  ++work.solves;
  try {
    if (sparse_)
      solve_sparsely(settings, work);
    else
      solve_densely(work);
  } catch (const NotPositiveDefinite& error) {
    throw NotPositiveDefinite(nodes_[error.node]);
  }
  for (int i = 0; i < size(); ++i) x.segment<3>(3 * nodes_[i]) = solution_.segment<3>(3 * i);
}

void IndependentSystem::solve_densely(LinearWork& work) {
  const Stopwatch watch(work.solve_seconds);
  if (!current_ || !symmetric_ || !beyond_.empty()) {
    dense_.factor(matrix_, beyond_);
    current_ = true;
    symmetric_ = beyond_.empty();
    ++work.dense_factorisations;
  }
  dense_.solve(right_, solution_);
}

void IndependentSystem::factor(LinearWork& work) {
  const Stopwatch watch(work.factor_seconds);
  sparse_->cholesky.factor(matrix_);
  current_ = true;
  outdated_ = false;
  ++work.factorisations;
}

void IndependentSystem::solve_sparsely(const LinearSettings& settings, LinearWork& work) {
  Cholesky& cholesky = sparse_->cholesky;
  int& iterations = sparse_->iterations;
  if (current_)
    outdated_ = false;
  else if (outdated_ || iterations > sparse_->patience)
    factor(work);
  const auto apply = [this](const Eigen::VectorXd& from, Eigen::VectorXd& to) {
    matrix_.multiply(from, to);
    UnsymmetricBlocks::add_product(beyond_, from, to);
  };
  const auto precondition = [&](const Eigen::VectorXd& from, Eigen::VectorXd& to) { cholesky.solve(from, to); };
  const auto iterate = [&] {
    const Stopwatch watch(work.solve_seconds);
    iterations = 0;
    if (current_ && beyond_.empty()) return cholesky.solve(right_, solution_);
    iterations = sparse_->gmres.solve(apply, precondition, right_, solution_, settings.tolerance, settings.limit);
    work.gmres_iterations += iterations;
  };
  iterate();
  if (iterations < settings.limit || current_) return;
  factor(work);
  iterate();
}

}  // namespace talus
