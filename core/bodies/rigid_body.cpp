#include "bodies/rigid_body.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "bodies/finite_rotation.hpp"

namespace talus {

Vec3 RigidBody::spin() const { return rotation * inertia.ldlt().solve(rotation.transpose() * angular_momentum); }

Vec3 RigidBody::momentum_of(const Vec3& theta) const {
  const Vec3 phi = cayley_vector(theta), spin = inertia_now() * (touches ? phi : theta);
  return spin + 0.5 * phi.cross(spin);
}

Mat3 RigidBody::momentum_slope(const Vec3& theta) const {
  const Vec3 phi = cayley_vector(theta);
  const Mat3 inertia_start = inertia_now(), hat = cross_matrix(phi);
  const Mat3 phi_slope = cayley_tangent(phi);
  const Mat3 turned = touches ? phi_slope : inverse_rotation_tangent(theta);
  return (Mat3::Identity() + 0.5 * hat) * inertia_start * turned -
         0.5 * cross_matrix(inertia_start * (touches ? phi : theta)) * phi_slope;
}

}  // namespace talus
