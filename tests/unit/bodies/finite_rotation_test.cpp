#include "bodies/finite_rotation.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

namespace talus {
namespace {

const Vec3 axis = Vec3(1, -2, 0.5).normalized();

TEST(FiniteRotation, AgreesWithTheAxisAndTheAngle) {
  for (const double angle : {1e-9, 1e-4, 0.05, 0.0999, 0.1001, 1.5, 3.1}) {
    const Mat3 expected = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    EXPECT_LT((rotation_by(angle * axis) - expected).norm(), 1e-15) << angle;
    const Vec3 p(0.3, -0.7, 2);
    EXPECT_LT((turn_of(angle * axis, p) - (expected - Mat3::Identity()) * p).norm(), 3e-15) << angle;
  }
}

TEST(FiniteRotation, KeepsTheRelativeAccuracyOfTinyTurns) {
  const Vec3 p(0.3, -0.7, 2), theta = 1e-12 * axis;
  EXPECT_LT((turn_of(theta, p) - theta.cross(p)).norm(), 1e-11 * theta.norm() * p.norm());
}

TEST(FiniteRotation, RotationsFollowOneAnother) {
  const Vec3 earlier(0.4, -1.2, 0.3), later(-0.9, 0.2, 0.8);
  EXPECT_LT((rotation_by(composed(later, earlier)) - rotation_by(later) * rotation_by(earlier)).norm(), 1e-15);
  EXPECT_EQ(composed(Vec3::Zero(), Vec3::Zero()), Vec3::Zero());
  EXPECT_LT((composed(1e-13 * axis, 2e-13 * axis) - 3e-13 * axis).norm(), 1e-27);
}

TEST(FiniteRotation, TheTangentIsHowTheRotationChanges) {
  for (const double angle : {0.02, 0.3, 2.0}) {
    const Vec3 theta = angle * axis;
    constexpr double step = 1e-5;
    Mat3 differences;
    for (int k = 0; k < 3; ++k)
      differences.col(k) =
          (composed(theta + step * Vec3::Unit(k), -theta) - composed(theta - step * Vec3::Unit(k), -theta)) /
          (2 * step);
    EXPECT_LT((rotation_tangent(theta) - differences).norm(), 1e-9) << angle;
    EXPECT_LT((inverse_rotation_tangent(theta) * rotation_tangent(theta) - Mat3::Identity()).norm(), 1e-14) << angle;
  }
}

TEST(FiniteRotation, TheCayleyTangentIsHowItsVectorChanges) {
  for (const double angle : {0.02, 0.3, 2.0}) {
    const Vec3 theta = angle * axis;
    constexpr double step = 1e-5;
    Mat3 differences;
    for (int k = 0; k < 3; ++k) {
      const auto phi = [&](double turn) { return cayley_vector(composed(turn * Vec3::Unit(k), theta)); };
      differences.col(k) = (phi(step) - phi(-step)) / (2 * step);
    }
    EXPECT_LT((cayley_tangent(cayley_vector(theta)) - differences).norm(), 1e-8) << angle;
  }
}

}  // namespace
}  // namespace talus
