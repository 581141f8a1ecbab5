#include "verification/random/scene_numbers.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace talus {

namespace {

/// The finaliser of SplitMix64 (Steele, Lea & Flood 2014), which spreads a change of one bit over all.
std::uint64_t spread_bits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

}  // namespace

double SceneNumbers::between(double low, double high) { return low + (high - low) * even_.uniform(); }

double SceneNumbers::logarithmic(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

int SceneNumbers::whole(int low, int high) {
  return std::min(high, static_cast<int>(std::floor(between(low, static_cast<double>(high) + 1))));
}

bool SceneNumbers::chance(double probability) { return between(0, 1) < probability; }

Vec3 SceneNumbers::direction() {
  const double z = between(-1, 1), around = between(0, 2 * std::numbers::pi), r = std::sqrt(1 - z * z);
  return {r * std::cos(around), r * std::sin(around), z};
}

/// Shoemake's quaternion (1992).
Mat3 SceneNumbers::turn() {
  const double share = between(0, 1), first = between(0, 2 * std::numbers::pi),
               second = between(0, 2 * std::numbers::pi);
  const double a = std::sqrt(1 - share), b = std::sqrt(share);
  return Eigen::Quaterniond(b * std::cos(second), a * std::sin(first), a * std::cos(first), b * std::sin(second))
      .normalized()
      .toRotationMatrix();
}

std::uint64_t mixed_seed(std::uint64_t seed, std::string_view family, std::uint64_t number) {
  std::uint64_t mixed = spread_bits(seed);
  for (const char letter : family) mixed = spread_bits(mixed ^ static_cast<unsigned char>(letter));
  return spread_bits(mixed ^ number);
}

}  // namespace talus
