#include "render/scene/contact_places.hpp"

#include <gtest/gtest.h>

#include "mesh/block.hpp"

namespace talus {
namespace {

/// Two tetrahedra that share a corner's neighbourhood, the second above the first.
BlockSystem two_blocks() {
  Block lower;
  lower.mesh = {{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitZ()}, {{0, 1, 2, 3}}};
  lower.surface = {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{0, 3, 2}}};
  Block upper = lower;
  upper.mesh.nodes[3] = Vec3::UnitZ();
  return {.blocks = {lower, upper}, .joint_names = {}};
}

Frame moved(const Vec3& lower, const Vec3& upper) {
  Frame frame;
  frame.displacement.assign(4, lower);
  frame.displacement.insert(frame.displacement.end(), 4, upper);
  frame.contacts.push_back({.position = Vec3(0.2, 0.3, 0) + upper,
                            .normal = Vec3::UnitZ(),
                            .blocks = {0, 1},
                            .joint = 0,
                            .state = ContactState::stick,
                            .normal_force = 0,
                            .shear_force = Vec3::Zero(),
                            .area = 0});
  return frame;
}

TEST(ContactPlaces, AreThoseOfTheFrameAtTheTrueScale) {
  const Frame frame = moved(Vec3::Zero(), Vec3(0.01, 0, 0));
  EXPECT_EQ(contact_places(two_blocks(), frame, 1)[0], frame.contacts[0].position);
}

TEST(ContactPlaces, GoWithTheBlocksWhenDisplacementsAreExaggerated) {
  const Vec3 together(0.01, -0.02, 0.03);
  const Frame carried = moved(together, together);
  EXPECT_LT((contact_places(two_blocks(), carried, 10)[0] - (Vec3(0.2, 0.3, 0) + 10 * together)).norm(), 1e-12);
  const Vec3 slid(0.01, 0, 0);
  const Frame apart = moved(Vec3::Zero(), slid);
  const Vec3 midway = Vec3(0.2, 0.3, 0) + slid + 9 * 0.5 * slid;
  EXPECT_LT((contact_places(two_blocks(), apart, 10)[0] - midway).norm(), 1e-12);
}

TEST(ContactPlaces, FollowAFaceThatTurns) {
  Frame frame = moved(Vec3::Zero(), Vec3::Zero());
  // The upper block's corner at (1, 0, 0) is lifted: between the corners its displacement is linear.
  frame.displacement[4 + 1] = Vec3(0, 0, 1e-6);
  const Vec3 place = contact_places(two_blocks(), frame, 1001)[0];
  EXPECT_NEAR(place.z(), 1000 * 0.5 * 0.2 * 1e-6, 1e-9);
}

}  // namespace
}  // namespace talus
