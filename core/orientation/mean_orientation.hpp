#pragma once

#include <array>
#include <optional>
#include <span>

#include "orientation/attitude.hpp"

namespace talus {

/// Mean of poles taken as axes, which have no sense: the eigenvector of the largest eigenvalue of the orientation
/// tensor T = Σ x xᵀ / N (Scheidegger 1965; Woodcock 1977). It needs no hemisphere, so that poles on both sides of the
/// net's rim do not cancel.
struct AxisMean {
  Vec3 pole = Vec3::Zero();             ///< downward unit vector
  std::array<double, 3> eigenvalues{};  ///< largest first; their sum is 1. Equal: no preferred direction
};

/// Mean of a set by Fisher's distribution on the sphere (Fisher 1953).
struct FisherMean {
  int count = 0;
  Vec3 pole = Vec3::Zero();     ///< downward unit vector
  double resultant = 0;         ///< R, length of the sum of all unit poles on one side
  std::optional<double> kappa;  ///< (N−1)/(N−R); absent for a single pole and for poles that are all the same
};

/// Both throw std::invalid_argument when there is no pole. Poles: unit vectors of either sense.
AxisMean axis_mean(std::span<const Vec3> poles);
FisherMean fisher_mean(std::span<const Vec3> poles);

/// Half angle, in degrees, of the cone about the mean that holds the true mean with this probability:
/// cos θ = 1 − (N−R)/R · (p^(−1/(N−1)) − 1) with p = 1 − probability (Fisher 1953). Absent where κ is, and where even
/// the whole sphere is not certain enough.
std::optional<double> confidence_cone(const FisherMean& mean, double probability);

/// Half angle, in degrees, of the cone about the mean that holds this fraction of a Fisher distribution of κ:
/// the integral of its density, solved for the angle.
double spread_cone(double kappa, double fraction);

}  // namespace talus
