#include "effects/rigid_inertia.hpp"

#include <gmock/gmock.h>

#include "bodies/finite_rotation.hpp"
#include "effects/inertia.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

/// Whatever turn a moment comes to, it has done its work: Ȧ₁·θ, or Ȧ₁·φ of a body that touches others.
TEST(RigidInertia, AMomentGivesTheWorkOfTheTurn) {
  for (const bool touches : {false, true}) {
    BodySet set(test::rock_project(0, {}),
                test::block_system({test::box_block("B", Vec3(0, 0, 0), Vec3(1, 0.6, 0.3), BodyKind::rigid)}));
    RigidBody& body = set.rigid[0];
    body.touches = touches;
    body.angular_momentum = body.inertia * Vec3(3, -5, 8);
    Inertia inertia(set);
    const double length = 0.02;
    inertia.begin_step({0, length, 1, TimeIntegration::constant_acceleration()});
    const Vec3 theta(0.1, -0.05, 0.22);
    Increment d = Increment::Zero(set.unknowns());
    d.segment<3>(3 * body.rotation_dof_block) = body.radius * theta;
    const double before = kinetic_energy(set, body);
    const Vec3 momentum = body.angular_momentum;
    inertia.accept(d);
    set.move(d);
    const double work = body.moment.dot(touches ? cayley_vector(theta) : theta);
    EXPECT_NEAR(kinetic_energy(set, body) - before, work, 1e-12 * before);
    EXPECT_GT(std::abs(work), 0.1 * before);
    EXPECT_LT((body.angular_momentum - momentum - length * body.moment).norm(), 1e-12 * momentum.norm());
  }
}

}  // namespace
}  // namespace talus
