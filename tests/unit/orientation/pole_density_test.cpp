#include "orientation/pole_density.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "orientation/attitude.hpp"

namespace talus {
namespace {

/// The mean over the hemisphere, by bands of equal area.
double mean_over_hemisphere(const PoleDensity& density) {
  const int bands = 400, sectors = 400;
  double sum = 0;
  for (int band = 0; band < bands; ++band)
    for (int sector = 0; sector < sectors; ++sector) {
      const double depth = (band + 0.5) / bands;
      sum += density(direction_of({360.0 * sector / sectors, degrees(std::asin(depth))}));
    }
  return sum / bands / sectors;
}

std::vector<Vec3> three_poles() { return {pole_of({85, 90}), pole_of({40, 200}), pole_of({2, 10})}; }

TEST(PoleDensity, ByFisherHasAMeanOfOne) {
  EXPECT_NEAR(mean_over_hemisphere(PoleDensity(three_poles(), DensityMethod::fisher)), 1, 0.002);
}

TEST(PoleDensity, ByFisherIsTheExponentAtASinglePole) {
  const PoleDensity density({pole_of({40, 200})}, DensityMethod::fisher);
  EXPECT_NEAR(density(pole_of({40, 200})), 100, 1e-9);
  // 10° off: 100 e^(100 (cos 10° − 1)) = 21.89.
  EXPECT_NEAR(density(pole_of({50, 200})), 100 * std::exp(100 * (std::cos(radians(10)) - 1)), 1e-9);
}

TEST(PoleDensity, ByKambExpectsThreeSigmaOfUniformPoles) {
  // The mean of N e^(k(|cos θ| − 1)) over the hemisphere is N (1 − e^(−k))/k, which Kamb's k makes 3 σ.
  for (const int copies : {1, 20}) {
    std::vector<Vec3> poles;
    for (int i = 0; i < copies; ++i)
      for (const Vec3& pole : three_poles()) poles.push_back(pole);
    const PoleDensity density(poles, DensityMethod::kamb);
    const double k = 2 * (1 + static_cast<double>(poles.size()) / 9);
    EXPECT_NEAR(density.sharpness(), k, 1e-12);
    EXPECT_NEAR(mean_over_hemisphere(density), 3 * (1 - std::exp(-k)), 0.002);
  }
}

TEST(PoleDensity, OfAHundredEqualPolesByKambIsTheirNumberOverSigma) {
  // N = 100: k = 24.22, σ = √(100 · 11.11)/24.22 = 1.376, 100/σ = 72.67.
  const std::vector<Vec3> poles(100, pole_of({30, 60}));
  EXPECT_NEAR(PoleDensity(poles, DensityMethod::kamb)(pole_of({30, 60})), 72.67, 0.01);
}

TEST(PoleDensity, IsTheSameOnBothSidesOfTheRim) {
  for (const DensityMethod method : {DensityMethod::fisher, DensityMethod::kamb}) {
    const PoleDensity density(three_poles(), method);
    EXPECT_NEAR(density(direction_of({70, 0})), density(direction_of({250, 0})), 1e-12);
  }
}

TEST(PoleDensity, OfNothingIsZero) { EXPECT_EQ(PoleDensity({}, DensityMethod::kamb)(Vec3(0, 0, -1)), 0); }

TEST(DensityGrid, FindsTheDensestPlaceAndReadsBetweenNodes) {
  const PoleDensity density({pole_of({40, 200})}, DensityMethod::fisher);
  const DensityGrid grid = density_grid(density, Projection::equal_area, 201);
  EXPECT_GT(grid.densest.dot(pole_of({40, 200})), std::cos(radians(0.6)));
  EXPECT_NEAR(grid.largest, 100, 1);
  const Vec3 beside = pole_of({46, 205});
  EXPECT_NEAR(grid.at(projected(beside, Projection::equal_area)), density(beside), 0.5);
}

TEST(ContourLevels, AreFullSteps) {
  EXPECT_THAT(contour_levels(DensityMethod::fisher, 17), testing::ElementsAre(2, 4, 6, 8, 10, 12, 14, 16));
  EXPECT_THAT(contour_levels(DensityMethod::kamb, 9), testing::ElementsAre(2, 4, 6, 8));
  EXPECT_THAT(contour_levels(DensityMethod::kamb, 72.67), testing::ElementsAre(10, 20, 30, 40, 50, 60, 70));
  EXPECT_THAT(contour_levels(DensityMethod::fisher, 0), testing::IsEmpty());
  for (double largest = 0.05; largest < 1e4; largest *= 1.7)
    for (const DensityMethod method : {DensityMethod::fisher, DensityMethod::kamb})
      EXPECT_LE(contour_levels(method, largest).size(), 8u) << largest;
}

}  // namespace
}  // namespace talus
