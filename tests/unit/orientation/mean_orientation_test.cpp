#include "orientation/mean_orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace talus {
namespace {

/// Four poles at an angle about the downward vertical, north, east, south and west of it.
std::vector<Vec3> cross_about_vertical(double angle) {
  std::vector<Vec3> poles;
  for (const double direction : {0.0, 90.0, 180.0, 270.0}) poles.push_back(pole_of({angle, direction}));
  return poles;
}

TEST(AxisMean, OfACrossHasTheEigenvaluesOfItsClosedForm) {
  // Each pole is (± sin, 0, −cos) or (0, ± sin, −cos): T = diag(sin²/2, sin²/2, cos²).
  const AxisMean mean = axis_mean(cross_about_vertical(30));
  EXPECT_NEAR(mean.pole.z(), -1, 1e-12);
  EXPECT_NEAR(mean.eigenvalues[0], 0.75, 1e-12);
  EXPECT_NEAR(mean.eigenvalues[1], 0.125, 1e-12);
  EXPECT_NEAR(mean.eigenvalues[2], 0.125, 1e-12);
}

TEST(AxisMean, DoesNotCancelAcrossTheRim) {
  // Two planes 10° to either side of the vertical one that dips east: their downward poles point west and east.
  const std::vector<Vec3> poles{pole_of({80, 90}), pole_of({80, 270})};
  EXPECT_NEAR(std::abs(axis_mean(poles).pole.x()), 1, 1e-12);
  const FisherMean mean = fisher_mean(poles);
  EXPECT_NEAR(std::abs(mean.pole.x()), 1, 1e-12);
  EXPECT_NEAR(mean.resultant, 2 * std::cos(radians(10)), 1e-12);
}

TEST(FisherMean, OfACrossHasTheResultantOfItsClosedForm) {
  const FisherMean mean = fisher_mean(cross_about_vertical(20));
  const double cosine = std::cos(radians(20));
  EXPECT_EQ(mean.count, 4);
  EXPECT_NEAR(mean.resultant, 4 * cosine, 1e-12);
  EXPECT_NEAR(mean.kappa.value(), 3 / (4 - 4 * cosine), 1e-9);
}

TEST(FisherMean, IsThatOfPmagPysPublishedExample) {
  // Tauxe et al. (2016), PmagPy, ipmag.fisher_mean: declination 140, 127, 142, 136; inclination 21, 23, 19, 22 give
  // 136.308°, 21.348°, R = 3.98121390, k = 159.692515, α95 = 7.2928914°.
  std::vector<Vec3> lines;
  for (const LineAttitude& line : {LineAttitude{140, 21}, {127, 23}, {142, 19}, {136, 22}})
    lines.push_back(direction_of(line));
  const FisherMean mean = fisher_mean(lines);
  EXPECT_NEAR(attitude_of(mean.pole).trend, 136.30838974272072, 1e-9);
  EXPECT_NEAR(attitude_of(mean.pole).plunge, 21.34778402689999, 1e-9);
  EXPECT_NEAR(mean.resultant, 3.9812138971889026, 1e-12);
  EXPECT_NEAR(mean.kappa.value(), 159.69251473636305, 1e-7);
  EXPECT_NEAR(confidence_cone(mean, 0.95).value(), 7.292891411309177, 1e-9);
}

TEST(FisherMean, IsTheSameWhateverTheSenseOfAPole) {
  std::vector<Vec3> poles{pole_of({70, 10}), pole_of({75, 20}), pole_of({85, 15}), pole_of({88, 200})};
  const FisherMean mean = fisher_mean(poles);
  poles[1] = -poles[1];
  poles[3] = -poles[3];
  EXPECT_NEAR((fisher_mean(poles).pole - mean.pole).norm(), 0, 1e-12);
  EXPECT_NEAR(fisher_mean(poles).kappa.value(), mean.kappa.value(), 1e-9);
}

TEST(FisherMean, OfOnePoleOrOfEqualOnesHasNoKappa) {
  const std::vector<Vec3> one{pole_of({40, 50})}, equal(3, pole_of({40, 50}));
  EXPECT_FALSE(fisher_mean(one).kappa);
  EXPECT_FALSE(fisher_mean(equal).kappa);
  EXPECT_FALSE(confidence_cone(fisher_mean(one), 0.95));
  EXPECT_NEAR((fisher_mean(equal).pole - one.front()).norm(), 0, 1e-12);
}

TEST(FisherMean, OfNothingIsRefused) {
  EXPECT_THROW(fisher_mean({}), std::invalid_argument);
  EXPECT_THROW(axis_mean({}), std::invalid_argument);
}

TEST(SpreadCone, HoldsItsFractionOfTheDistribution) {
  // Numerically: the share of κ sin θ e^(κ cos θ) below the angle.
  for (const double kappa : {2.0, 20.0, 200.0})
    for (const double fraction : {0.5, 0.95}) {
      const double limit = radians(spread_cone(kappa, fraction));
      double inside = 0, all = 0;
      const int pieces = 200000;
      for (int i = 0; i < pieces; ++i) {
        const double angle = std::numbers::pi * (i + 0.5) / pieces;
        const double weight = std::sin(angle) * std::exp(kappa * (std::cos(angle) - 1));
        all += weight;
        if (angle < limit) inside += weight;
      }
      EXPECT_NEAR(inside / all, fraction, 1e-3) << kappa;
    }
}

TEST(SpreadCone, OfATightSetIsThatOfTheNormalDistribution) {
  // Fisher (1953): for large κ, half of the poles lie within 67.5°/√κ and 63 % within 81°/√κ.
  EXPECT_NEAR(spread_cone(400, 0.5), 67.5 / 20, 0.01);
  EXPECT_NEAR(spread_cone(400, 0.6321), 81.0 / 20, 0.01);
}

}  // namespace
}  // namespace talus
