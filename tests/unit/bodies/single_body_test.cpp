// Rigid and affine bodies: how their nodes follow.
#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "bodies/block_motion.hpp"
#include "bodies/body_set.hpp"
#include "bodies/finite_rotation.hpp"
#include "support/one_block.hpp"

namespace talus {
namespace {

using test::one_block;

TEST(SingleBody, NodesOfAnAffineBodyFollowItsControlNodes) {
  BodySet set = one_block(BodyKind::affine);
  const auto field = [](const Vec3& x) { return Vec3(0.1 * x.y(), 0.2 * x.x() - 0.1 * x.z(), 0.05 * x.z() + 1); };
  Increment d(set.unknowns());
  for (const int n : set.nodes.free) d.segment<3>(3 * set.nodes.dof_block[n]) = field(set.nodes.reference[n]);
  for (int n = 0; n < set.nodes.of_blocks; ++n)
    EXPECT_LT((set.node_increment(n, d) - field(set.nodes.reference[n])).norm(), 1e-13);
  set.move(d);
  for (int n = 0; n < set.nodes.of_blocks; ++n)
    EXPECT_LT((set.nodes.position[n] - set.nodes.reference[n] - field(set.nodes.reference[n])).norm(), 1e-13);
}

TEST(SingleBody, ARigidBodyTurnsByAnyAngleAndKeepsItsShape) {
  BodySet set = one_block(BodyKind::rigid);
  ASSERT_EQ(set.unknowns(), 6);
  const RigidBody& rigid = set.rigid.front();
  EXPECT_DOUBLE_EQ(rigid.mass, 2600);
  EXPECT_LT((rigid.inertia.diagonal() - 2600.0 / 12 * Vec3(4.25, 1.25, 5)).norm(), 1e-10);
  const Vec3 shift(0.3, -1, 2), theta(0.5, 2, -1);
  Increment d(6);
  d.segment<3>(3 * set.nodes.dof_block[rigid.centre]) = shift;
  d.segment<3>(3 * rigid.rotation_dof_block) = rigid.radius * theta;
  const Vec3 centre(1.5, 3, 3.25);
  const std::vector<Vec3> before = set.nodes.position;
  std::vector<Vec3> increments;
  for (int n = 0; n < set.nodes.of_blocks; ++n) increments.push_back(set.node_increment(n, d));
  set.move(d);
  for (int n = 0; n < set.nodes.of_blocks; ++n) {
    const Vec3 expected = centre + shift + rotation_by(theta) * (before[n] - centre);
    EXPECT_LT((set.nodes.position[n] - expected).norm(), 1e-14);
    EXPECT_LT((before[n] + increments[n] - expected).norm(), 1e-14);
  }
  const BlockMotion motion = block_motion(set, 0);
  EXPECT_NEAR(motion.rotation, theta.norm(), 1e-14);
  EXPECT_EQ(motion.relative_volume_change, 0);
  EXPECT_LT((motion.displacement - shift).norm(), 1e-15);
}

TEST(SingleBody, VelocitiesOfNodesAreThoseOfTranslationAndSpin) {
  BodySet set = one_block(BodyKind::rigid);
  RigidBody& rigid = set.rigid.front();
  const Vec3 velocity(1, 2, -3), spin(0.5, -0.4, 2);
  set.nodes.velocity[rigid.centre] = velocity;
  rigid.angular_momentum = rigid.inertia_now() * spin;
  set.carry_velocities();
  double fastest = 0;
  for (int n = 0; n < set.nodes.of_blocks; ++n) {
    const Vec3 expected = velocity + spin.cross(set.nodes.position[n] - set.nodes.position[rigid.centre]);
    EXPECT_LT((set.nodes.velocity[n] - expected).norm(), 1e-14);
    fastest = std::max(fastest, expected.norm());
  }
  EXPECT_GE(set.top_speed(), fastest);

  std::vector<BodyWay> ways;
  set.find_ways(0.1, {}, ways);
  double beside = 0;
  for (int n = 0; n < set.nodes.of_blocks; ++n)
    beside = std::max(beside, (0.1 * set.nodes.velocity[n] - ways[0].mean).norm());
  EXPECT_LT((ways[0].mean - 0.1 * velocity).norm(), 0.1) << "of its nodes, not of its centroid";
  EXPECT_NEAR(ways[0].beside, beside, 1e-15);
  const std::vector<char> left_out = {1};
  set.find_ways(0.1, left_out, ways);
  EXPECT_EQ(ways[0].mean.norm() + ways[0].beside, 0);
}

TEST(SingleBody, AHeldBodyHasNoUnknownsAndIsLetGoWhereItStood) {
  for (const BodyKind kind : {BodyKind::rigid, BodyKind::affine}) {
    BodySet set = one_block(kind);
    const int unknowns = set.unknowns();
    set.hold({true});
    EXPECT_EQ(set.unknowns(), 0);
    EXPECT_EQ(set.node_increment(0, Increment()), Vec3::Zero());
    set.hold({false});
    EXPECT_EQ(set.unknowns(), unknowns);
    EXPECT_EQ(set.nodes.position, set.nodes.reference);
  }
}

}  // namespace
}  // namespace talus
