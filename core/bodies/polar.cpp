#include "bodies/polar.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

namespace talus {

namespace {

Mat3 rotation_by_singular_values(const Mat3& f) {
  const Eigen::JacobiSVD<Mat3> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 sign = Mat3::Identity();
  sign(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * sign * svd.matrixV().transpose();
}

}  // namespace

Mat3 rotation_of(const Mat3& f) {
  constexpr double nearly_singular = 1e-6, converged = 1e-28;
  constexpr int limit = 20;
  const double size = f.squaredNorm() / 3;
  if (!(f.determinant() > nearly_singular * size * std::sqrt(size))) return rotation_by_singular_values(f);
  Mat3 r = f;
  for (int i = 0; i < limit; ++i) {
    const Mat3 next = 0.5 * (r + r.inverse().transpose());
    const double change = (next - r).squaredNorm();
    r = next;
    if (change <= converged) return r;
  }
  return rotation_by_singular_values(f);
}

}  // namespace talus
