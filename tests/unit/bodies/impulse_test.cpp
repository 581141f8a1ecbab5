// Impulses on bodies of every kind: momentum is what was given, and single bodies answer alike.
#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "bodies/impulse.hpp"
#include "support/one_block.hpp"

namespace talus {
namespace {

using test::one_block;

/// Of nodes that have unknowns, by the consistent mass; and of a rigid body.
Vec3 momentum(const BodySet& set) {
  Vec3 sum = Vec3::Zero();
  for (const Element& element : set.elements)
    for (const int node : element.nodes) sum += element.mass / 4 * set.nodes.velocity[node];
  for (const RigidBody& rigid : set.rigid) sum += rigid.mass * set.nodes.velocity[rigid.centre];
  return sum;
}

const std::vector<int> nodes{0, 1, 3};
const std::vector<double> weights{0.5, 0.2, 0.3};
const Vec3 impulse(300, -200, 500);

TEST(Impulse, ABodyOfAnyKindTakesUpTheMomentumThatItIsGiven) {
  for (const BodyKind kind : {BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra}) {
    BodySet set = one_block(kind);
    InverseMasses masses(set);
    const StruckPoint point(set, masses, nodes, weights, 1);
    point.strike(set, impulse);
    EXPECT_LT((momentum(set) - impulse).norm(), 1e-10) << to_string(kind);
  }
}

TEST(Impulse, TheMobilityIsHowFastThePointMovesOff) {
  for (const BodyKind kind : {BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra}) {
    BodySet set = one_block(kind);
    InverseMasses masses(set);
    const StruckPoint point(set, masses, nodes, weights, 1);
    const Vec3 before = point.velocity(set);
    point.strike(set, impulse);
    const Vec3 change = point.velocity(set) - before;
    EXPECT_LT((change - point.mobility() * impulse).norm(), 1e-12 * change.norm()) << to_string(kind);
    set.carry_velocities();
    EXPECT_LT((velocity_of(set, nodes, weights, 1) - point.velocity(set)).norm(), 1e-12 * change.norm())
        << to_string(kind);
  }
}

TEST(Impulse, ARigidBodyTurnsByTheMomentOfTheImpulse) {
  BodySet set = one_block(BodyKind::rigid);
  InverseMasses masses(set);
  StruckPoint(set, masses, nodes, weights, 1).strike(set, impulse);
  Vec3 place = Vec3::Zero();
  for (std::size_t k = 0; k < nodes.size(); ++k) place += weights[k] * set.nodes.position[nodes[k]];
  const RigidBody& rigid = set.rigid.front();
  EXPECT_LT((rigid.angular_momentum - (place - set.nodes.position[rigid.centre]).cross(impulse)).norm(), 1e-10);
}

TEST(Impulse, AFixedBodyMovesAsItIsPrescribedTo) {
  BodySet set = one_block(BodyKind::fixed);
  for (Vec3& way : set.nodes.prescribed) way = Vec3(0.02, 0, 0);
  InverseMasses masses(set);
  const StruckPoint point(set, masses, nodes, weights, 0.01);
  EXPECT_EQ(point.mobility().norm(), 0);
  EXPECT_LT((point.velocity(set) - Vec3(2, 0, 0)).norm(), 1e-14);
}

}  // namespace
}  // namespace talus
