#include "solve/dynamics/energy_gain.hpp"

#include <gtest/gtest.h>

#include <array>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

TEST(EnergyGain, LoadsGiveWhatTheyDoAndBlowsTheRest) {
  const double step = 0.1, mass = 2600;
  BodySet set(test::rock_project(0, {}),
              test::block_system({test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1), BodyKind::rigid)}));
  RigidBody& body = set.rigid[0];
  Vec3& velocity = set.nodes.velocity[body.centre];
  velocity = Vec3(1, 0, -2);
  EnergyGain energy(set);
  energy.note_start();
  set.nodes.position[body.centre] += step * (velocity + 0.5 * step * Vec3(0, 0, -9.81));
  velocity += step * Vec3(0, 0, -9.81);
  const std::array bodies{0};
  energy.note_without_contact(bodies, step);
  EXPECT_NEAR(energy.gain(), 0, 1e-9 * energy.kinetic());

  const double before = energy.kinetic();
  velocity.z() = 4;
  body.angular_momentum = body.inertia * Vec3(0, 3, 0);
  const double inertia = mass / 6;  // kg m², of the cube
  EXPECT_NEAR(energy.kinetic(), 0.5 * mass * (1 + 16) + 0.5 * inertia * 9, 1e-9 * before);
  EXPECT_NEAR(energy.gain(), energy.kinetic() - before, 1e-9 * before);
}

/// What stress does within a body is by what its nodes go, not only its centroid.
TEST(EnergyGain, StressesGiveWhatTheyDoAndBlowsTheRest) {
  const double step = 0.1;
  for (const BodyKind kind : {BodyKind::affine, BodyKind::tetrahedra}) {
    BodySet set(test::rock_project(0, {}),
                test::block_system({test::box_block("B", Vec3(0, 0, 0), Vec3(1, 1, 1), kind)}));
    for (const int n : set.nodes.free) set.nodes.velocity[n] = Vec3(1, 0.2 * n, -2);
    EnergyGain energy(set);
    energy.note_start();
    for (const int n : set.nodes.free) {
      const Vec3 acceleration(3, -0.1 * n * n, 2 * n);
      set.nodes.position[n] += step * (set.nodes.velocity[n] + 0.5 * step * acceleration);
      set.nodes.velocity[n] += step * acceleration;
    }
    const std::array bodies{0};
    energy.note_without_contact(bodies, step);
    const double before = energy.kinetic();
    EXPECT_NEAR(energy.gain(), 0, 1e-9 * before) << to_string(kind);
    set.nodes.velocity[set.nodes.free[2]] += Vec3(4, 0, 1);
    EXPECT_NEAR(energy.gain(), energy.kinetic() - before, 1e-9 * before) << to_string(kind);
  }
}

}  // namespace
}  // namespace talus
