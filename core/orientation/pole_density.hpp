#pragma once

#include <string_view>
#include <vector>

#include "orientation/projection.hpp"

namespace talus {

/// How poles are smeared over the sphere before they are contoured.
enum class DensityMethod { fisher, kamb };

constexpr std::string_view to_string(DensityMethod method) {
  return method == DensityMethod::fisher ? "Fisher" : "Kamb";
}

/// Density of poles at any place of the hemisphere.
///
/// Fisher: every pole is spread by a Fisher distribution of κ, on both ends of its axis. The sum is told in per cent of
/// all poles per 1 % of the hemisphere, which is the multiple of a uniform density; its mean over the hemisphere is 1.
/// κ = 100 spreads a pole as wide as the usual counting circle of 1 %.
///
/// Kamb (1959), smoothed as Vollmer (1995) does it: every pole weighs e^(k(|cos θ| − 1)) with k = 2(1 + N/E²), which
/// makes the number expected of uniform poles E = 3 times its standard deviation σ = √(N(k/2 − 1)/k²). The sum is told
/// in σ: 3 is uniform, more than 6 is no accident.
class PoleDensity {
 public:
  /// `poles`: unit vectors of either sense; none at all give a density of zero.
  PoleDensity(std::vector<Vec3> poles, DensityMethod method);

  double operator()(const Vec3& line) const;  ///< `line`: unit vector of either sense

  DensityMethod method() const { return method_; }
  double sharpness() const { return sharpness_; }  ///< κ or k, the exponent of a pole's influence
  /// What the density is told in, for a legend.
  std::string_view unit() const { return method_ == DensityMethod::fisher ? "% per 1 % area" : "σ"; }

 private:
  std::vector<Vec3> poles_;
  DensityMethod method_;
  double sharpness_ = 0, scale_ = 0;
};

/// Densities at the nodes of a square grid over the net, row by row from south to north.
struct DensityGrid {
  int size = 0;                ///< nodes a side; the first and the last lie on the rim's west and east, south and north
  std::vector<double> values;  ///< outside the rim those of the opposite side, so that contours reach the rim
  double largest = 0;          ///< of the nodes on the net
  Vec3 densest = Vec3(0, 0, -1);  ///< where that is

  /// Between nodes: bilinear. `place` on the net of radius 1.
  double at(const Vec2& place) const;
};

DensityGrid density_grid(const PoleDensity& density, Projection projection, int size = 101);

/// Levels to draw contours at, from the lowest up: full steps of 1, 2 or 5 (Kamb: of 2 σ or multiples), at most eight.
std::vector<double> contour_levels(DensityMethod method, double largest);

}  // namespace talus
