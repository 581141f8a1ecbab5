#include "linear/tangent_factor.hpp"

namespace talus {

int TangentFactor::solve(const SymmetricBlocks& matrix, std::span<const UnsymmetricBlocks::Pair> unsymmetric,
                         const Eigen::VectorXd& b, const LinearSettings& settings, Eigen::VectorXd& x) {
  const auto precondition = [this](const Eigen::VectorXd& from, Eigen::VectorXd& to) { cholesky_.solve(from, to); };
  const auto apply = [&](const Eigen::VectorXd& from, Eigen::VectorXd& to) {
    matrix.multiply(from, to);
    UnsymmetricBlocks::add_product(unsymmetric, from, to);
  };
  return gmres_.solve(apply, precondition, b, x, settings.tolerance, settings.limit);
}

}  // namespace talus
