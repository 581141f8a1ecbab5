#include "bodies/strain.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace talus {

ElementShape element_shape(const Corners& corners) {
  Mat3 edges;
  for (int i = 0; i < 3; ++i) edges.col(i) = corners[i + 1] - corners[0];
  const Mat3 inverse = edges.inverse();
  ElementShape shape;
  shape.volume = edges.determinant() / 6;
  for (int i = 0; i < 3; ++i) shape.gradient[i + 1] = inverse.row(i).transpose();
  shape.gradient[0] = -(shape.gradient[1] + shape.gradient[2] + shape.gradient[3]);
  return shape;
}

Voigt strain(const ElementShape& shape, const Corners& displacement) {
  Mat3 slope = Mat3::Zero();  // ∂u/∂x; differences to corner 0 so that a translation strains nothing at all
  for (int r = 1; r < 4; ++r) slope += (displacement[r] - displacement[0]) * shape.gradient[r].transpose();
  Voigt e;
  e << slope(0, 0), slope(1, 1), slope(2, 2), slope(0, 1) + slope(1, 0), slope(1, 2) + slope(2, 1),
      slope(2, 0) + slope(0, 2);
  return e;
}

Elastic Elastic::of(const Material& material) {
  const double e = material.young, nu = material.poisson;
  return {e * nu / ((1 + nu) * (1 - 2 * nu)), e / (2 * (1 + nu))};
}

Voigt Elastic::stress(const Voigt& e) const {
  Voigt s;
  const double volumetric = lambda * (e[0] + e[1] + e[2]);
  for (int i = 0; i < 3; ++i) s[i] = volumetric + 2 * mu * e[i];
  for (int i = 3; i < 6; ++i) s[i] = mu * e[i];
  return s;
}

double Elastic::energy_density(const Voigt& s) const {
  const double trace = s[0] + s[1] + s[2];
  const double square = s.head<3>().squaredNorm() + 2 * s.tail<3>().squaredNorm();
  return (square - lambda / (3 * lambda + 2 * mu) * trace * trace) / (4 * mu);
}

Vec3 corner_force(const ElementShape& shape, const Voigt& s, int corner) {
  const Vec3& g = shape.gradient[corner];
  return shape.volume * Vec3(s[0] * g[0] + s[3] * g[1] + s[5] * g[2], s[3] * g[0] + s[1] * g[1] + s[4] * g[2],
                             s[5] * g[0] + s[4] * g[1] + s[2] * g[2]);
}

Mat3 stiffness_block(const ElementShape& shape, const Elastic& elastic, int a, int b) {
  const Vec3 &ga = shape.gradient[a], &gb = shape.gradient[b];
  Mat3 block = elastic.lambda * ga * gb.transpose() + elastic.mu * gb * ga.transpose();
  block.diagonal().array() += elastic.mu * ga.dot(gb);
  return shape.volume * block;
}

}  // namespace talus
