#include "bodies/rigid_body.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "bodies/finite_rotation.hpp"

namespace talus {

Vec3 RigidBody::spin() const { return rotation * inertia.ldlt().solve(rotation.transpose() * angular_momentum); }

Vec3 RigidBody::momentum_of(const Vec3& theta) const {
  const Vec3 spin = inertia_now() * theta;
  return spin + 0.5 * cayley_vector(theta).cross(spin);
}

Mat3 RigidBody::momentum_slope(const Vec3& theta) const {
  const Vec3 phi = cayley_vector(theta);
  const Mat3 inertia_start = inertia_now(), hat = cross_matrix(phi);
  const Mat3 phi_slope = Mat3::Identity() - 0.5 * hat + 0.25 * phi * phi.transpose();
  return (Mat3::Identity() + 0.5 * hat) * inertia_start * inverse_rotation_tangent(theta) -
         0.5 * cross_matrix(inertia_start * theta) * phi_slope;
}

}  // namespace talus
