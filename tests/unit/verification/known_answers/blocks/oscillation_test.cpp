#include "verification/known_answers/blocks/oscillation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace talus {
namespace {

constexpr double g = 9.81;

TEST(DrivenMass, UnderAConstantDriveIsUniformlyAccelerated) {
  const DrivenMass mass{[](double) { return 3.0; }, 1, 1};
  EXPECT_NEAR(mass.path(2, 1e-3).back(), 0.5 * 2 * 4, 1e-9);
}

TEST(DrivenMass, RestsBelowItsFriction) {
  const DrivenMass mass{[](double t) { return std::cos(t); }, 1.01, 1.01};
  EXPECT_EQ(mass.path(10, 1e-3).back(), 0);
}

TEST(DrivenMass, ComesToWherePotraAndOthersFoundIt) {
  const DrivenMass mass{[](double t) { return 8 * std::cos(t); }, 0.8 * g, 0.8 * g};
  EXPECT_NEAR(mass.path(10, 1e-4).back(), -8.69717e-3, 1e-8);
}

TEST(DrivenMass, OnAShakenBaseSlipsAsTheClosedFormSays) {
  // v = (A/ω)(cos ωt₁ − cos ωt) − μg(t − t₁) from A sin ωt₁ = μg to v = 0.
  const double a = 3, omega = 2 * std::numbers::pi, resistance = 0.2 * g;
  const DrivenMass mass{[&](double t) { return a * std::sin(omega * t); }, resistance, resistance};
  EXPECT_NEAR(mass.path(0.6, 1e-5).back(), 44.21e-3, 1e-5);
}

TEST(DrivenMass, SlidesDownAnInclineByTheBlocksOfNewmark) {
  const double dip = 20 * std::numbers::pi / 180, friction = 30 * std::numbers::pi / 180;
  const double factor = std::cos(friction - dip) / std::cos(friction);
  const auto shaking = [](double t) { return t < 3 ? 3 * std::sin(2 * std::numbers::pi * t) : 0.0; };
  const DrivenMass mass{[&](double t) { return factor * shaking(t); }, factor * g * std::tan(friction - dip), 1e9};
  EXPECT_NEAR(mass.path(4, 1e-5).back(), 0.23042, 1e-5);
}

}  // namespace
}  // namespace talus
