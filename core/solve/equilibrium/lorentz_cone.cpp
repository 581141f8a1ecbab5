#include "solve/equilibrium/lorentz_cone.hpp"

#include <algorithm>
#include <cmath>

namespace talus::lorentz_cone {

namespace {

Vec3 mirrored(const Vec3& v) { return {v[0], -v[1], -v[2]}; }

/// Of a v with determinant 1, the symmetric matrix whose square is 2 v vᵀ − diag(1, −1, −1). That of the mirrored v is
/// its inverse.
Mat3 boost(const Vec3& v) {
  Mat3 matrix = Mat3::Identity();
  matrix.row(0) = v.transpose();
  matrix.col(0) = v;
  matrix.bottomRightCorner<2, 2>() += v.tail<2>() * v.tail<2>().transpose() / (1 + v[0]);
  return matrix;
}

}  // namespace

double determinant(const Vec3& v) {
  const double length = v.tail<2>().norm();
  return (v[0] - length) * (v[0] + length);
}

Vec3 inverse(const Vec3& v) { return mirrored(v) / determinant(v); }

Vec3 product(const Vec3& v, const Vec3& w) { return {v.dot(w), v[0] * w[1] + w[0] * v[1], v[0] * w[2] + w[0] * v[2]}; }

Vec3 quotient(const Vec3& product, const Vec3& v) {
  Vec3 w;
  w[0] = product.dot(mirrored(v)) / determinant(v);
  w.tail<2>() = (product.tail<2>() - w[0] * v.tail<2>()) / v[0];
  return w;
}

double fraction_inside(const Vec3& v, const Vec3& change) {
  constexpr double never = 1e300;
  double fraction = change[0] < 0 ? -v[0] / change[0] : never;
  // The determinant on the way is c + 2 b f + a f² after a fraction f; what matters is where it vanishes first.
  const double a = change.dot(mirrored(change)), b = v.dot(mirrored(change)), c = determinant(v);
  const double discriminant = b * b - a * c;
  if (a >= 0 && (b >= 0 || discriminant < 0)) return fraction;
  const double root = std::sqrt(std::max(0.0, discriminant));
  return std::min(fraction, b < 0 ? c / (root - b) : -(b + root) / a);
}

Scaling::Scaling(const Vec3& x, const Vec3& z) {
  const double of_x = determinant(x), of_z = determinant(z);
  const Vec3 unit_x = x / std::sqrt(of_x), unit_z = z / std::sqrt(of_z);
  const Vec3 mean = (unit_x + mirrored(unit_z)) / std::sqrt(2 * (1 + unit_x.dot(unit_z)));
  const double size = std::sqrt(std::sqrt(of_x / of_z));
  matrix = size * boost(mean);
  inverse = boost(mirrored(mean)) / size;
  scaled = matrix * z;
}

}  // namespace talus::lorentz_cone
