#include "orientation/mean_orientation.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <stdexcept>

namespace talus {
namespace {

/// Sum of the poles, each in the sense that is nearer to `axis`.
Vec3 sum_along(std::span<const Vec3> poles, const Vec3& axis) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& pole : poles) sum += pole.dot(axis) < 0 ? Vec3(-pole) : pole;
  return sum;
}

}  // namespace

AxisMean axis_mean(std::span<const Vec3> poles) {
  if (poles.empty()) throw std::invalid_argument("a mean needs at least one pole");
  Mat3 tensor = Mat3::Zero();
  for (const Vec3& pole : poles) tensor += pole * pole.transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(tensor / static_cast<double>(poles.size()));
  const auto& values = solver.eigenvalues();
  return {downward(solver.eigenvectors().col(2)), {values[2], values[1], values[0]}};
}

FisherMean fisher_mean(std::span<const Vec3> poles) {
  // Which sense of a pole counts depends on the mean, which depends on the senses: the axis is near enough to begin
  // with, and a pole turns at most a few times.
  constexpr int most_passes = 20;
  Vec3 axis = axis_mean(poles).pole, sum = sum_along(poles, axis);
  for (int pass = 0; pass < most_passes; ++pass) {
    axis = sum.normalized();
    const Vec3 next = sum_along(poles, axis);
    if (next == sum) break;
    sum = next;
  }
  FisherMean mean{static_cast<int>(poles.size()), downward(axis), sum.norm(), std::nullopt};
  constexpr double rounding = 1e-12;
  const double missing = mean.count - mean.resultant;
  if (mean.count > 1 && missing > rounding * mean.count) mean.kappa = (mean.count - 1) / missing;
  return mean;
}

std::optional<double> confidence_cone(const FisherMean& mean, double probability) {
  if (!mean.kappa) return std::nullopt;
  const double missing = mean.count - mean.resultant;
  const double cosine = 1 - missing / mean.resultant * (std::pow(1 / (1 - probability), 1.0 / (mean.count - 1)) - 1);
  if (cosine < -1) return std::nullopt;
  return degrees(std::acos(cosine));
}

double spread_cone(double kappa, double fraction) {
  // ∫ κ sin θ e^(κ cos θ) / (2 sinh κ) from 0 to the angle, with e^κ taken out so that large κ do not overflow.
  const double cosine = 1 + std::log1p(-fraction * (1 - std::exp(-2 * kappa))) / kappa;
  return degrees(std::acos(std::max(-1.0, cosine)));
}

}  // namespace talus
