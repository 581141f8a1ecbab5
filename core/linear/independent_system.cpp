#include "linear/independent_system.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/stopwatch.hpp"
#include "linear/not_positive_definite.hpp"

namespace talus {

namespace {

/// A part that couples more than this fraction of all pairs that may couple is left to the factor of the whole system,
/// which costs hardly more and can be used for longer.
constexpr double largest_sparse_fraction = 0.9;
/// A matrix that is solved more often than this gets a factor of the whole system, which costs nothing from then on.
constexpr int few_solves = 3;

}  // namespace

IndependentSystem::IndependentSystem(std::vector<int> nodes, BlockPattern pattern)
    : nodes_(std::move(nodes)), own_(nodes_.size()) {
  std::iota(own_.begin(), own_.end(), 0);
  matrix_.set_pattern(std::move(pattern));
  right_.resize(3 * size());
  if (3 * size() <= DenseSolver::largest) return;
  sparse_ = std::make_unique<Sparse>();
  sparse_->of_size.resize(DenseSolver::largest_part / 3 + 1);
}

void IndependentSystem::analyse() {
  if (sparse_->analysed) return;
  sparse_->analysed = true;
  sparse_->factor.analyse(matrix_.pattern());
  // A solve touches each entry of the factor twice. The cost of a factorisation in units of that, at the rates of one
  // core, is the number of GMRES iterations that an old factor may take before a new one is cheaper.
  constexpr double factor_rate = 20e9, solve_rate = 10e9;
  const Cholesky& cholesky = sparse_->factor.cholesky();
  sparse_->patience =
      std::clamp(static_cast<int>(cholesky.flops() / factor_rate / (16 * cholesky.entries() / solve_rate)), 5, 30);
}

double IndependentSystem::take_right_side(const Eigen::VectorXd& b) {
  for (int i = 0; i < size(); ++i) right_.segment<3>(3 * i) = b.segment<3>(3 * nodes_[i]);
  return right_.norm();
}

void IndependentSystem::solve(const SymmetricBlocks& whole, const LinearSettings& settings, double negligible,
                              Trials& trials, LinearWork& work, Eigen::VectorXd& x) {
  const bool changed = matrix_.assign_part(whole, nodes_);
  current_ = current_ && !changed;
  solved_before_ = changed ? 0 : solved_before_ + 1;
  ++work.solves;
  try {
    if (!sparse_) {
      solve_densely(work);
    } else if (needs_factor_ || current_ || !solve_without_factor(settings, trials, work)) {
      needs_factor_ = false;
      analyse();
      sparse_->solution_of_parts.setZero(right_.size());
      if (!current_ && solved_before_ < few_solves) solve_parts(settings, negligible, work);
      solve_sparsely(settings, work);
      solution_ += sparse_->solution_of_parts;
    }
  } catch (const NotPositiveDefinite& error) {
    throw NotPositiveDefinite(nodes_[error.node]);
  }
  for (int i = 0; i < size(); ++i) x.segment<3>(3 * nodes_[i]) = solution_.segment<3>(3 * i);
}

/// Factors are made again, of the same matrix. That of a dense system with an unsymmetric part is not used again.
void IndependentSystem::archive(StateArchive& state) {
  state(matrix_, current_, solved_before_, outdated_, needs_factor_, symmetric_);
  if (sparse_) {
    bool analysed = sparse_->analysed;
    state(analysed);
    if (analysed) {
      analyse();
      state(sparse_->factor);
    }
    state(sparse_->iterations);
  } else if (state.reads() && current_ && symmetric_)
    dense_.factor(matrix_, {}, own_);
}

void IndependentSystem::solve_densely(LinearWork& work) {
  const Stopwatch watch(work.solve_seconds);
  if (!current_ || !symmetric_ || !unsymmetric_.empty()) {
    dense_.factor(matrix_, unsymmetric_, own_);
    current_ = true;
    symmetric_ = unsymmetric_.empty();
    ++work.dense_factorisations;
  }
  dense_.solve(right_, solution_);
}

bool IndependentSystem::solve_without_factor(const LinearSettings& settings, Trials& trials, LinearWork& work) {
  if (size() < IncompleteSolver::many_blocks || !trials.is_due()) return false;
  const Stopwatch watch(work.solve_seconds);
  const bool solved = sparse_->incomplete.solve(matrix_, unsymmetric_, right_, settings, work, solution_);
  trials.note(solved);
  return solved;
}

/// What is left of the right-hand side is that of a part with most of the couplings.
void IndependentSystem::solve_parts(const LinearSettings& settings, double negligible, LinearWork& work) {
  const Stopwatch watch(work.solve_seconds);
  Sparse& s = *sparse_;
  s.parts.find(matrix_, unsymmetric_);
  const double negligible_part = negligible / std::sqrt(static_cast<double>(s.parts.count()));
  const double many = largest_sparse_fraction * (matrix_.pattern().slots() - size());
  for (int part = 0; part < s.parts.count(); ++part) {
    const std::span<const int> nodes = s.parts.nodes(part);
    const auto count = static_cast<Eigen::Index>(nodes.size());
    if (s.parts.couplings(part) > many) continue;
    s.right.resize(3 * count);
    for (Eigen::Index k = 0; k < count; ++k) {
      s.right.segment<3>(3 * k) = right_.segment<3>(3 * nodes[k]);
      right_.segment<3>(3 * nodes[k]).setZero();
    }
    if (!(s.right.norm() > negligible_part)) continue;
    if (3 * count <= DenseSolver::largest_part) {
      DenseSolver& dense = s.of_size[count];
      dense.factor(matrix_, unsymmetric_, nodes);
      dense.solve(s.right, s.solution);
      ++work.dense_factorisations;
    } else {
      s.large_part.take(matrix_, unsymmetric_, nodes);
      s.large_part.solve(s.right, settings, work, s.solution);
    }
    for (Eigen::Index k = 0; k < count; ++k)
      s.solution_of_parts.segment<3>(3 * nodes[k]) = s.solution.segment<3>(3 * k);
  }
}

void IndependentSystem::factor(LinearWork& work) {
  const Stopwatch watch(work.factor_seconds);
  sparse_->factor.factor(matrix_);
  current_ = true;
  outdated_ = false;
  ++work.factorisations;
}

void IndependentSystem::solve_sparsely(const LinearSettings& settings, LinearWork& work) {
  solution_.setZero(right_.size());
  if (right_.isZero(0)) return;
  int& iterations = sparse_->iterations;
  if (current_)
    outdated_ = false;
  else if (outdated_ || iterations > sparse_->patience)
    factor(work);
  const auto iterate = [&] {
    const Stopwatch watch(work.solve_seconds);
    iterations = 0;
    if (current_ && unsymmetric_.empty()) return sparse_->factor.solve(right_, solution_);
    iterations = sparse_->factor.solve(matrix_, unsymmetric_, right_, settings, solution_);
    work.gmres_iterations += iterations;
  };
  iterate();
  if (iterations >= settings.limit && !current_) {
    factor(work);
    iterate();
  }
  if (iterations >= settings.limit) ++work.gmres_limits;
}

}  // namespace talus
