#include "orientation/random_numbers.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus {

double RandomNumbers::uniform() {
  constexpr double step = 0x1p-53;  // the upper 53 bits, in the middle of their interval
  return (static_cast<double>(engine_() >> 11) + 0.5) * step;
}

double RandomNumbers::normal() {
  const double length = std::sqrt(-2 * std::log(uniform()));
  return length * std::cos(2 * std::numbers::pi * uniform());
}

double RandomNumbers::exponential() { return -std::log(uniform()); }

double RandomNumbers::positive_normal(double mean, double deviation) {
  for (;;)
    if (const double value = mean + deviation * normal(); value > 0) return value;
}

double RandomNumbers::lognormal(double mean, double deviation) {
  const double variance = std::log1p(deviation * deviation / (mean * mean));  // of the logarithm
  return std::exp(std::log(mean) - variance / 2 + std::sqrt(variance) * normal());
}

Vec3 RandomNumbers::fisher(const Vec3& mean, double kappa) {
  const double share = uniform(), turn = 2 * std::numbers::pi * uniform();
  const double cosine = std::max(-1.0, 1 + std::log(share + (1 - share) * std::exp(-2 * kappa)) / kappa);
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const Vec3 first = mean.unitOrthogonal(), second = mean.cross(first);
  return cosine * mean + sine * (std::cos(turn) * first + std::sin(turn) * second);
}

}  // namespace talus
