#pragma once

#include <cstdint>
#include <random>

#include "base/vector.hpp"

namespace talus {

/// Numbers drawn by chance that are the same for the same seed on every machine: the engine is that of the C++
/// standard, which fixes its bits; the standard's distributions are left to each library, so they are made here.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  /// Between 0 and 1, neither included.
  double uniform();
  /// Of mean 0 and standard deviation 1 (Box & Muller 1958).
  double normal();
  /// Negative exponential, of mean 1.
  double exponential();
  /// Normal of this mean and standard deviation, drawn again until it is positive.
  double positive_normal(double mean, double deviation);
  /// Whose own mean and standard deviation these are, not those of its logarithm.
  double lognormal(double mean, double deviation);
  /// Unit vector of Fisher's distribution of κ > 0 about a unit vector (Fisher, Lewis & Embleton 1987, section 3.6.2).
  Vec3 fisher(const Vec3& mean, double kappa);

 private:
  std::mt19937_64 engine_;
};

}  // namespace talus
