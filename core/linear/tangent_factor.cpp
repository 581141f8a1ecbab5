#include "linear/tangent_factor.hpp"

namespace talus {

int solve_tangent(Gmres& gmres, const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric,
                  const Gmres::Map& precondition, const Eigen::VectorXd& b, double tolerance, int limit,
                  Eigen::VectorXd& x) {
  const auto apply = [&](const Eigen::VectorXd& from, Eigen::VectorXd& to) {
    matrix.multiply(from, to);
    UnsymmetricBlocks::add_product(unsymmetric, from, to);
  };
  return gmres.solve(apply, precondition, b, x, tolerance, limit);
}

int TangentFactor::solve(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric,
                         const Eigen::VectorXd& b, const LinearSettings& settings, Eigen::VectorXd& x) {
  const auto precondition = [this](const Eigen::VectorXd& from, Eigen::VectorXd& to) { cholesky_.solve(from, to); };
  return solve_tangent(gmres_, matrix, unsymmetric, precondition, b, settings.tolerance, settings.limit, x);
}

}  // namespace talus
