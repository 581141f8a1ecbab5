#include "bodies/strain.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace talus {
namespace {

const Corners corners{Vec3(0.1, 0.2, -0.1), Vec3(1.3, 0.1, 0.2), Vec3(0.2, 0.9, 0.1), Vec3(0.3, 0.2, 1.4)};
const Material rock{"rock", 2600, 25e9, 0.24};

Corners affine(const Mat3& slope, const Vec3& shift) {
  Corners d;
  for (int i = 0; i < 4; ++i) d[i] = slope * corners[i] + shift;
  return d;
}

TEST(ElementShape, VolumeIsThatOfTheTetrahedronAndGradientsReproduceLinearFields) {
  const ElementShape shape = element_shape(corners);
  EXPECT_NEAR(shape.volume, (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(corners[3] - corners[0]) / 6,
              1e-15);
  Vec3 gradient = Vec3::Zero();
  for (int i = 0; i < 4; ++i)
    gradient += (3 * corners[i].x() - 2 * corners[i].y() + corners[i].z()) * shape.gradient[i];
  EXPECT_LT((gradient - Vec3(3, -2, 1)).norm(), 1e-13);
}

TEST(Strain, OfAnAffineFieldIsItsSymmetricSlopeWithEngineeringShears) {
  Mat3 slope;
  slope << 1e-3, 2e-3, -1e-3, 4e-3, -2e-3, 3e-3, 5e-3, 1e-3, 7e-3;
  const Voigt e = strain(element_shape(corners), affine(slope, Vec3(5, 6, 7)));
  Voigt expected;
  expected << 1e-3, -2e-3, 7e-3, 6e-3, 4e-3, 4e-3;
  EXPECT_LT((e - expected).norm(), 1e-14);
}

TEST(Elastic, UniaxialStressFollowsYoungsModulusAndPoissonsRatio) {
  Voigt e;
  e << 1e-4, -0.24e-4, -0.24e-4, 0, 0, 0;
  const Elastic elastic = Elastic::of(rock);
  const Voigt s = elastic.stress(e);
  EXPECT_NEAR(s[0], 25e9 * 1e-4, 1e-6);
  EXPECT_NEAR(s[1], 0, 1e-6);
  EXPECT_NEAR(elastic.energy_density(s), 0.5 * 25e9 * 1e-8, 1e-9);
}

TEST(StiffnessBlock, TimesDisplacementsIsTheForceOfTheStressTheyMake) {
  const ElementShape shape = element_shape(corners);
  const Elastic elastic = Elastic::of(rock);
  Corners d{Vec3(1e-3, 0, 2e-3), Vec3(-1e-3, 3e-3, 0), Vec3(0, 1e-3, 1e-3), Vec3(2e-3, 2e-3, -1e-3)};
  const Voigt s = elastic.stress(strain(shape, d));
  for (int a = 0; a < 4; ++a) {
    Vec3 force = Vec3::Zero();
    for (int b = 0; b < 4; ++b) force += stiffness_block(shape, elastic, a, b) * d[b];
    EXPECT_LT((force - corner_force(shape, s, a)).norm(), 1e-9 * force.norm());
  }
}

TEST(StiffnessBlock, ResistsNoTranslationAndNoSmallRotation) {
  const ElementShape shape = element_shape(corners);
  const Elastic elastic = Elastic::of(rock);
  Mat3 skew;
  skew << 0, -0.3, 0.2, 0.3, 0, -0.1, -0.2, 0.1, 0;
  const Corners d = affine(skew, Vec3(1, -2, 3));
  for (int a = 0; a < 4; ++a) {
    Vec3 force = Vec3::Zero();
    for (int b = 0; b < 4; ++b) force += stiffness_block(shape, elastic, a, b) * d[b];
    EXPECT_LT(force.norm(), 1e-13 * 25e9);
  }
}

}  // namespace
}  // namespace talus
