#include "solve/equilibrium/lorentz_cone.hpp"

#include <gmock/gmock.h>

namespace talus {
namespace {

const Vec3 x(2, 0.7, -1.5), z(1e-3, 2e-4, 9e-4);
constexpr double rounding = 1e-13;

TEST(LorentzCone, VectorTimesItsInverseIsOne) {
  EXPECT_LT((lorentz_cone::product(x, lorentz_cone::inverse(x)) - Vec3::UnitX()).norm(), rounding);
}

TEST(LorentzCone, QuotientGivesBackItsFactor) {
  const Vec3 factor(0.3, -4, 5);
  EXPECT_LT((lorentz_cone::quotient(lorentz_cone::product(x, factor), x) - factor).norm(), 10 * rounding);
}

TEST(LorentzCone, VectorLeavesTheConeWhereItsDeterminantFirstVanishes) {
  for (const Vec3& change : {Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(-3, 1, 2), Vec3(1, 4, 4), Vec3(-2, -0.7, 1.5)}) {
    const double fraction = lorentz_cone::fraction_inside(x, change);
    EXPECT_LT(std::abs(lorentz_cone::determinant(x + fraction * change)), rounding) << change.transpose();
    EXPECT_GT(lorentz_cone::determinant(x + 0.999 * fraction * change), 0) << change.transpose();
    EXPECT_GT(x[0] + 0.999 * fraction * change[0], 0) << change.transpose();
  }
}

TEST(LorentzCone, VectorThatGoesInwardNeverLeaves) {
  EXPECT_GT(lorentz_cone::fraction_inside(x, Vec3(1, 0.2, -0.9)), 1e100);
  EXPECT_GT(lorentz_cone::fraction_inside(x, Vec3::Zero()), 1e100);
}

TEST(LorentzCone, ScalingBringsTwoVectorsTogether) {
  const lorentz_cone::Scaling scaling(x, z);
  EXPECT_LT((scaling.matrix * scaling.inverse - Mat3::Identity()).norm(), 100 * rounding);
  EXPECT_LT((scaling.matrix * z - scaling.scaled).norm(), rounding);
  EXPECT_LT((scaling.inverse * x - scaling.scaled).norm(), rounding);
  EXPECT_NEAR(scaling.scaled.squaredNorm(), x.dot(z), rounding);
}

TEST(LorentzCone, VectorsOfOneNumberAreThoseOfTheHalfLine) {
  const Vec3 one(3, 0, 0), other(0.5, 0, 0);
  EXPECT_DOUBLE_EQ(lorentz_cone::inverse(one)[0], 1.0 / 3);
  EXPECT_DOUBLE_EQ(lorentz_cone::fraction_inside(one, Vec3(-6, 0, 0)), 0.5);
  EXPECT_LT((lorentz_cone::Scaling(one, other).matrix - std::sqrt(6.0) * Mat3::Identity()).norm(), rounding);
}

}  // namespace
}  // namespace talus
