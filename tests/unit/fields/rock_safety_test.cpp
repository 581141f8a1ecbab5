// The safety of rock, against what closed forms say of it and against all planes, one by one.
#include "fields/rock_safety.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "base/units.hpp"
#include "fields/field_values.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

Voigt principal(double xx, double yy, double zz) {
  Voigt stress;
  stress << xx, yy, zz, 0, 0, 0;
  return stress;
}

constexpr RockStrength granite{.cohesion = 10e6, .friction_angle = 50};

TEST(RockSafety, IsOneAtTheUniaxialCompressiveStrength) {
  const double phi = radians(50), strength = 2 * 10e6 * std::cos(phi) / (1 - std::sin(phi));
  EXPECT_NEAR(rock_safety(principal(0, 0, -strength), granite), 1, 1e-12);
  EXPECT_NEAR(rock_safety(principal(0, -strength, 0), granite), 1, 1e-12);
  EXPECT_LT(rock_safety(principal(0, 0, -1.001 * strength), granite), 1);
  EXPECT_GT(rock_safety(principal(0, 0, -0.999 * strength), granite), 1);
}

TEST(RockSafety, IsOneAtTheTriaxialStrength) {
  const double phi = radians(50), cell = 5e6;
  const double passive = (1 + std::sin(phi)) / (1 - std::sin(phi));
  const double largest = 2 * 10e6 * std::sqrt(passive) + cell * passive;
  EXPECT_NEAR(rock_safety(principal(-cell, -largest, -2 * cell), granite), 1, 1e-12);
}

TEST(RockSafety, OfPureShearWithoutFrictionIsCohesionOverShear) {
  Voigt shear = Voigt::Zero();
  shear[3] = 2e6;
  EXPECT_NEAR(rock_safety(shear, {.cohesion = 5e6, .friction_angle = 0}), 2.5, 1e-12);
}

TEST(RockSafety, OfDryRubbleInAWedgeIsTangentOverMobilised) {
  // Without cohesion F = tan φ / tan φ_m, sin φ_m = (σ₁ − σ₃)/(σ₁ + σ₃).
  const double mobilised = std::asin((3e6 - 1.5e6) / (3e6 + 1.5e6));
  EXPECT_NEAR(rock_safety(principal(-3e6, -2e6, -1.5e6), {.cohesion = 0, .friction_angle = 35}),
              std::tan(radians(35)) / std::tan(mobilised), 1e-12);
}

TEST(RockSafety, IsTheLeastOfAllPlanes) {
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  const Mat3 tensor = turn * Vec3(-2e6, -9e6, -30e6).asDiagonal() * turn.transpose();
  Voigt stress;
  stress << tensor(0, 0), tensor(1, 1), tensor(2, 2), tensor(0, 1), tensor(1, 2), tensor(2, 0);
  double least = most_safety;
  for (double azimuth = 0; azimuth < 360; azimuth += 1)
    for (double plunge = 0; plunge <= 90; plunge += 1) {
      const double a = radians(azimuth), p = radians(plunge);
      const Vec3 normal(std::cos(p) * std::cos(a), std::cos(p) * std::sin(a), std::sin(p));
      const Vec3 traction = tensor * normal;
      const double pressed = -traction.dot(normal), shear = (traction + pressed * normal).norm();
      if (shear > 0) least = std::min(least, (10e6 + pressed * std::tan(radians(50))) / shear);
    }
  EXPECT_LE(rock_safety(stress, granite), least);
  EXPECT_NEAR(rock_safety(stress, granite), least, 1e-3 * least);
}

TEST(RockSafety, OfTensionIsThatOfTheCutOff) {
  const RockStrength cut{.cohesion = 10e6, .friction_angle = 50, .tensile_strength = 2e6};
  EXPECT_NEAR(rock_safety(principal(1e6, 1e6, 1e6), cut), 2, 1e-12);
  EXPECT_NEAR(rock_safety(principal(4e6, 0, 0), cut), 0.5, 1e-12);
  const double apex = 10e6 / std::tan(radians(50));
  EXPECT_NEAR(rock_safety(principal(apex, apex, apex), cut), 2e6 / apex, 1e-12);
  EXPECT_EQ(rock_safety(principal(1.01 * apex, 0, 0), granite), 0);
}

TEST(RockSafety, EndsWhereNothingIsMobilised) {
  EXPECT_EQ(rock_safety(Voigt::Zero(), granite), most_safety);
  EXPECT_EQ(rock_safety(principal(-5e6, -5e6, -5e6), granite), most_safety);
}

TEST(RockSafety, IsAFieldOfBlocksThatHaveStressAndStrength) {
  BlockSystem system = test::cube_on_slab();
  Frame frame;
  for (const Block& block : system.blocks) {
    frame.displacement.resize(frame.displacement.size() + block.mesh.nodes.size(), Vec3::Zero());
    frame.stress.resize(frame.stress.size() + block.mesh.tetrahedra.size(), principal(0, 0, -4e6));
  }
  const Field& field = field_named("stress.safety");
  EXPECT_NE(why_absent(system, frame, field), "");
  system.strengths = {RockStrength{.cohesion = 1e6, .friction_angle = 0}};
  EXPECT_EQ(why_absent(system, frame, field), "");
  const std::vector<double> values = FieldValues(system).of(frame, field);
  const std::size_t of_slab = system.blocks[0].mesh.tetrahedra.size();
  ASSERT_EQ(values.size(), frame.stress.size());
  EXPECT_TRUE(std::isnan(values.front())) << "fixed";
  EXPECT_NEAR(values[of_slab], 0.5, 1e-12);
  system.blocks[1].body = BodyKind::rigid;
  EXPECT_TRUE(std::isnan(FieldValues(system).of(frame, field).back())) << "rigid";
}

}  // namespace
}  // namespace talus
