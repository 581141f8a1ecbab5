#pragma once

#include <Eigen/Geometry>

#include "base/vector.hpp"

/// Rotations of any size as vectors θ = angle · axis [rad], and how they change (Simo & Vu-Quoc 1986; Iserles et al.
/// 2000). All are accurate to round-off for small angles too.
namespace talus {

/// v̂ with v̂ x = v × x.
Mat3 cross_matrix(const Vec3& v);

/// v̂ M and M v̂, by half the products.
inline Mat3 cross_times(const Vec3& v, const Mat3& m) {
  Mat3 product;
  for (int k = 0; k < 3; ++k) product.col(k) = v.cross(m.col(k));
  return product;
}
inline Mat3 times_cross(const Mat3& m, const Vec3& v) {
  Mat3 product;
  product.col(0) = v[2] * m.col(1) - v[1] * m.col(2);
  product.col(1) = v[0] * m.col(2) - v[2] * m.col(0);
  product.col(2) = v[1] * m.col(0) - v[0] * m.col(1);
  return product;
}

/// exp(θ̂), the rotation about θ by |θ|.
Mat3 rotation_by(const Vec3& theta);

/// exp(θ̂) − 1.
Mat3 turn_by(const Vec3& theta);

/// exp(θ̂) p − p [as p].
Vec3 turn_of(const Vec3& theta, const Vec3& p);

/// The rotation vector of exp(later) exp(earlier), at most π long.
Vec3 composed(const Vec3& later, const Vec3& earlier);

/// 2 tan(|θ|/2) θ/|θ|, the rotation vector of Cayley and Rodrigues. Above 2.8 rad, where no step should go, it grows
/// as θ.
Vec3 cayley_vector(const Vec3& theta);

/// δφ = C(φ) δω of the Cayley vector φ of exp(δω̂) exp(θ̂), for a small δω.
Mat3 cayley_tangent(const Vec3& phi);

/// δω of exp(θ̂ + δ) = exp(δω̂) exp(θ̂), for a small δ: δω = T(θ) δ.
Mat3 rotation_tangent(const Vec3& theta);

/// T(θ)⁻¹, for |θ| < 2π.
Mat3 inverse_rotation_tangent(const Vec3& theta);

}  // namespace talus
