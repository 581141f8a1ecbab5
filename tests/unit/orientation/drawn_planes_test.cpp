#include "orientation/drawn_planes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "orientation/mean_orientation.hpp"

namespace talus {
namespace {

Cut set_of(int count) {
  Cut cut;
  cut.joint = "J1";
  cut.dip = 60;
  cut.dip_direction = 90;
  cut.through = Vec3(1, 2, 3);
  cut.spacing = 2;
  cut.count = count;
  return cut;
}

std::vector<double> spacings_of(const Cut& cut) {
  const std::vector<Cut> planes = single_planes(cut);
  std::vector<double> spacings;
  for (std::size_t i = 1; i < planes.size(); ++i)
    spacings.push_back((planes[i].through - planes[i - 1].through).norm());
  return spacings;
}

TEST(DrawnPlanes, WithoutALawAreParallelAndEquallyFar) {
  const std::vector<Cut> planes = single_planes(set_of(3));
  ASSERT_EQ(planes.size(), 3u);
  EXPECT_FALSE(is_drawn(set_of(3)));
  // Upward along the normal of 60/90, (sin 60°, 0, cos 60°).
  EXPECT_NEAR((planes[2].through - Vec3(1 + 4 * std::sqrt(3) / 2, 2, 3 + 2)).norm(), 0, 1e-12);
  EXPECT_EQ(planes[2].dip, 60);
  EXPECT_FALSE(planes[2].spacing);
}

TEST(DrawnPlanes, OfALawOfSpacingHaveItsMeanAndDeviation) {
  struct Expected {
    SpacingLaw law;
    std::optional<double> given;
    double mean, deviation;
  };
  // A normal law without a deviation has half the mean, cut off two deviations below it: with λ = φ(2)/Φ(2) = 0.0552
  // the mean is 2 + λ, the variance 1 − 2λ − λ².
  for (const Expected& expected :
       {Expected{SpacingLaw::normal, {}, 2.0552, 0.9415}, Expected{SpacingLaw::normal, 0.3, 2, 0.3},
        Expected{SpacingLaw::exponential, {}, 2, 2}, Expected{SpacingLaw::lognormal, 0.5, 2, 0.5}}) {
    Cut cut = set_of(20001);
    cut.spacing_law = expected.law;
    cut.spacing_deviation = expected.given;
    double sum = 0, squares = 0;
    for (const double spacing : spacings_of(cut)) {
      EXPECT_GE(spacing, 0);
      sum += spacing;
      squares += spacing * spacing;
    }
    const double mean = sum / 20000;
    EXPECT_NEAR(mean, expected.mean, 0.02 * expected.deviation);  // three standard errors
    EXPECT_NEAR(std::sqrt(squares / 20000 - mean * mean), expected.deviation, 0.03 * expected.deviation);
  }
}

TEST(DrawnPlanes, ScatterByKappaAboutTheMean) {
  Cut cut = set_of(5000);
  cut.fisher_kappa = 80;
  std::vector<Vec3> poles;
  for (const Cut& plane : single_planes(cut)) poles.push_back(pole_of({plane.dip, plane.dip_direction}));
  const FisherMean found = fisher_mean(poles);
  EXPECT_NEAR(found.kappa.value(), 80, 5);
  EXPECT_GT(found.pole.dot(pole_of({60, 90})), std::cos(radians(0.6)));
}

TEST(DrawnPlanes, AreTheSameForTheSameSeedAndOthersForAnother) {
  Cut cut = set_of(10);
  cut.spacing_law = SpacingLaw::exponential;
  cut.fisher_kappa = 50;
  EXPECT_EQ(single_planes(cut), single_planes(cut));
  Cut other = cut;
  other.seed = 2;
  EXPECT_NE(single_planes(cut), single_planes(other));
  other = cut;
  other.fisher_kappa.reset();
  EXPECT_EQ(spacings_of(cut), spacings_of(other)) << "a scatter moves no plane";
}

}  // namespace
}  // namespace talus
