#include "bodies/rigid_body.hpp"

#include <Eigen/Cholesky>

#include "bodies/finite_rotation.hpp"

namespace talus {

Vec3 RigidBody::spin() const { return rotation * inertia.ldlt().solve(rotation.transpose() * angular_momentum); }

Vec3 RigidBody::momentum_of(const Vec3& theta) const { return rotation_by(0.5 * theta) * inertia_now() * theta; }

Mat3 RigidBody::momentum_slope(const Vec3& theta) const {
  const Mat3 halfway = rotation_by(0.5 * theta) * inertia_now();
  return (halfway - 0.5 * cross_matrix(halfway * theta) * rotation_tangent(0.5 * theta)) *
         inverse_rotation_tangent(theta);
}

}  // namespace talus
