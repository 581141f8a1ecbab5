#include "bodies/finite_rotation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace talus {

namespace {

constexpr double widest_step = 2.8;  // rad, for the Cayley vector

/// Below this square of the angle the series are exact to round-off.
constexpr double small_square = 0.01;

/// Of a series Σ (−1)ⁿ a₀ a₁ … aₙ squareⁿ with these ratios of its terms.
template <std::size_t count>
double alternating(double square, const double (&ratios)[count]) {
  double sum = 1;
  for (std::size_t i = count - 1; i > 0; --i) sum = 1 - square * ratios[i] * sum;
  return ratios[0] * sum;
}

double sine_over_angle(double square) {  // sin t / t
  constexpr double ratios[] = {1, 1.0 / 6, 1.0 / 20, 1.0 / 42, 1.0 / 72, 1.0 / 110};
  if (square < small_square) return alternating(square, ratios);
  const double t = std::sqrt(square);
  return std::sin(t) / t;
}

double cosine_over_square(double square) {  // (1 − cos t) / t²
  constexpr double ratios[] = {1.0 / 2, 1.0 / 12, 1.0 / 30, 1.0 / 56, 1.0 / 90, 1.0 / 132};
  if (square < small_square) return alternating(square, ratios);
  return (1 - std::cos(std::sqrt(square))) / square;
}

double cubic_over_cube(double square) {  // (t − sin t) / t³
  constexpr double ratios[] = {1.0 / 6, 1.0 / 20, 1.0 / 42, 1.0 / 72, 1.0 / 110, 1.0 / 156};
  if (square < small_square) return alternating(square, ratios);
  return (1 - sine_over_angle(square)) / square;
}

}  // namespace

Mat3 cross_matrix(const Vec3& v) {
  Mat3 m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

Mat3 turn_by(const Vec3& theta) {
  const double square = theta.squaredNorm();
  const Mat3 hat = cross_matrix(theta);
  return sine_over_angle(square) * hat + cosine_over_square(square) * hat * hat;
}

Mat3 rotation_by(const Vec3& theta) { return Mat3::Identity() + turn_by(theta); }

Vec3 turn_of(const Vec3& theta, const Vec3& p) {
  const double square = theta.squaredNorm();
  const Vec3 once = theta.cross(p);
  return sine_over_angle(square) * once + cosine_over_square(square) * theta.cross(once);
}

Vec3 composed(const Vec3& later, const Vec3& earlier) {
  const auto quaternion = [](const Vec3& theta) {
    const double quarter = theta.squaredNorm() / 4;  // of half the angle
    Eigen::Quaterniond q;
    q.w() = std::cos(std::sqrt(quarter));
    q.vec() = 0.5 * sine_over_angle(quarter) * theta;
    return q;
  };
  Eigen::Quaterniond both = quaternion(later) * quaternion(earlier);
  if (both.w() < 0) both.coeffs() *= -1;
  const double sine = both.vec().norm();
  if (sine == 0) return Vec3::Zero();
  return 2 * std::atan2(sine, both.w()) / sine * both.vec();
}

Vec3 cayley_vector(const Vec3& theta) {
  const double half = std::min(theta.norm(), widest_step) / 2;
  return (half > 0 ? std::tan(half) / half : 1) * theta;
}

Mat3 cayley_tangent(const Vec3& phi) {
  return Mat3::Identity() - 0.5 * cross_matrix(phi) + 0.25 * phi * phi.transpose();
}

Mat3 rotation_tangent(const Vec3& theta) {
  const double square = theta.squaredNorm();
  const Mat3 hat = cross_matrix(theta);
  return Mat3::Identity() + cosine_over_square(square) * hat + cubic_over_cube(square) * hat * hat;
}

Mat3 inverse_rotation_tangent(const Vec3& theta) {
  const double square = theta.squaredNorm();
  const Mat3 hat = cross_matrix(theta);
  // (1 − t/2 · cot(t/2)) / t², with cot(t/2) = sin t / (1 − cos t)
  const double factor = square < small_square
                            ? 1.0 / 12 + square / 720 + square * square / 30240 + square * square * square / 1209600
                            : (1 - 0.5 * sine_over_angle(square) / cosine_over_square(square)) / square;
  return Mat3::Identity() - 0.5 * hat + factor * hat * hat;
}

}  // namespace talus
