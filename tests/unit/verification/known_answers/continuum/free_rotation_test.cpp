#include "verification/known_answers/continuum/free_rotation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "verification/known_answers/support/scene.hpp"

using namespace talus;

TEST(FreeRotation, SymmetricTopPrecessesAtItsRate) {
  // I₁ = I₂: ω₁ turns into ω₂ at (I₃ − I₁)/I₁ ω₃.
  const Vec3 later = free_angular_velocity({1, 1, 1.5}, {0.3, 0, 2}, 0.7, 1000);
  EXPECT_NEAR(later[0], 0.3 * std::cos(0.7), 1e-12);
  EXPECT_NEAR(later[1], 0.3 * std::sin(0.7), 1e-12);
  EXPECT_DOUBLE_EQ(later[2], 2);
}

TEST(FreeRotation, MiddleAxisTurnsOverWhenItIsKnownTo) {
  const auto moments = zero_crossings({13, 10, 5}, {0.01, 1, 0.01}, 1, 3);
  EXPECT_NEAR(moments[0], 10.4848, 5e-5);
  EXPECT_NEAR(moments[1] - moments[0], 25.5508, 5e-5);
  EXPECT_NEAR(moments[2] - moments[1], 25.5508, 5e-5);
}

TEST(FreeRotation, AngularMomentumOfABoxIsItsInertiaTimesItsSpin) {
  CaseScene scene;
  scene.add_material({.name = "rock", .density = 2, .young = 1e9, .poisson = 0.2});
  scene.add_block("box", box_mesh({-0.5, -1, -1.5}, {0.5, 1, 1.5}, 2, 1, 3), BodyKind::tetrahedra);
  BodySet bodies(scene.project, scene.system);
  const Vec3 spin(0.3, -0.2, 0.5);
  for (std::size_t n = 0; n < bodies.nodes.position.size(); ++n)
    bodies.nodes.velocity[n] = spin.cross(bodies.nodes.position[n]);
  const Vec3 momentum = angular_momentum(bodies), expected = Vec3(13 * 0.3, 10 * -0.2, 5 * 0.5);  // mass 12, /12
  EXPECT_LT((momentum - expected).norm(), 1e-13);
}
