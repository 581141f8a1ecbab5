#include "linear/gmres.hpp"

#include <cmath>

namespace talus {

int Gmres::solve(const Map& apply, const Map& precondition, const Eigen::VectorXd& b, Eigen::VectorXd& x,
                 double tolerance, int limit) {
  const double size = b.norm();
  x.setZero(b.size());
  if (size == 0) return 0;
  basis_.resize(limit + 1);
  preconditioned_.resize(limit);
  hessenberg_.setZero(limit + 1, limit);
  cosine_.setZero(limit);
  sine_.setZero(limit);
  residual_.setZero(limit + 1);
  residual_[0] = size;
  basis_[0] = b / size;
  int k = 0;
  while (k < limit) {
    precondition(basis_[k], preconditioned_[k]);
    apply(preconditioned_[k], work_);
    for (int i = 0; i <= k; ++i) {
      hessenberg_(i, k) = work_.dot(basis_[i]);
      work_ -= hessenberg_(i, k) * basis_[i];
    }
    const double left = work_.norm();
    hessenberg_(k + 1, k) = left;
    for (int i = 0; i < k; ++i) {  // Givens rotations keep the matrix triangular
      const double upper = hessenberg_(i, k), lower = hessenberg_(i + 1, k);
      hessenberg_(i, k) = cosine_[i] * upper + sine_[i] * lower;
      hessenberg_(i + 1, k) = cosine_[i] * lower - sine_[i] * upper;
    }
    const double length = std::hypot(hessenberg_(k, k), left);
    if (!(length > 0)) break;
    cosine_[k] = hessenberg_(k, k) / length;
    sine_[k] = left / length;
    hessenberg_(k, k) = length;
    residual_[k + 1] = -sine_[k] * residual_[k];
    residual_[k] *= cosine_[k];
    ++k;
    if (std::abs(residual_[k]) <= tolerance * size || left <= 1e-14 * size) break;
    basis_[k] = work_ / left;
  }
  auto coefficients = residual_.head(k);
  hessenberg_.topLeftCorner(k, k).triangularView<Eigen::Upper>().solveInPlace(coefficients);
  for (int i = 0; i < k; ++i) x += coefficients[i] * preconditioned_[i];
  return std::abs(residual_[k]) <= tolerance * size ? k : limit;
}

}  // namespace talus
