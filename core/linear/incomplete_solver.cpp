#include "linear/incomplete_solver.hpp"

#include <functional>

#include "base/parallel.hpp"

namespace talus {

namespace {

/// An incomplete factor leaves an error everywhere, a whole one only where something slides: GMRES goes on to so much
/// of its tolerance. Piles of 1 000 cubes take 25 iterations of Newton's method for 34, of GMRES a quarter more.
constexpr double more_exact = 0.01;

}  // namespace

bool IncompleteSolver::prepare(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric) {
  bool factored = false;
  const auto prepare_some = [&](int first, int last) {
    if (first == 0) factored = incomplete_.factor(matrix);
    if (last == 2) rows_.set(matrix, unsymmetric);
  };
  in_parallel(2, 1, std::ref(prepare_some));
  return factored;
}

bool IncompleteSolver::solve(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric,
                             const Eigen::VectorXd& b, const LinearSettings& settings, LinearWork& work,
                             Eigen::VectorXd& x) {
  if (matrix.nodes() < many_blocks || !prepare(matrix, unsymmetric)) return false;
  const auto precondition = [this](const Eigen::VectorXd& from, Eigen::VectorXd& to) { incomplete_.solve(from, to); };
  const auto apply = [this](const Eigen::VectorXd& from, Eigen::VectorXd& to) { rows_.multiply(from, to); };
  const int iterations =
      gmres_.solve(apply, precondition, b, x, more_exact * settings.tolerance, settings.incomplete_limit);
  work.gmres_iterations += iterations;
  return iterations < settings.incomplete_limit;
}

}  // namespace talus
