#include "measures/block_history.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/error.hpp"
#include "base/units.hpp"
#include "unit/measures/slid_boxes.hpp"

// Blocks whose motion and forces are known.
namespace talus {
namespace {

const std::vector<int> slab_and_tower{1, 2};

double value(const BlockState& state, const char* name) { return block_quantity_named(name).of(state); }

TEST(BlockState, OfABoxThatWasMovedHasItsWayAndSpeed) {
  const BlockSystem system = floor_and_boxes();
  const Frame frame = moved_frame(system, {still, {3, 0, -4}, still, still}, {still, {1, 2, -2}, still, still});
  const std::vector<BlockState> states = BlockWatch(system, {2600}).states(frame, slab_and_tower);
  ASSERT_EQ(states.size(), 2u);
  EXPECT_NEAR(value(states[0], "displacement"), 5, 1e-12);
  EXPECT_NEAR(value(states[0], "displacement.z"), -4, 1e-12);
  EXPECT_NEAR(value(states[0], "speed"), 3, 1e-12);
  EXPECT_NEAR(value(states[0], "velocity.y"), 2, 1e-12);
  EXPECT_NEAR(value(states[0], "kinetic_energy"), 0.5 * 2600 * 4 * 9, 1e-6) << "m v² / 2";
  EXPECT_NEAR(value(states[0], "rotation"), 0, 1e-6);
  EXPECT_EQ(value(states[1], "speed"), 0);
}

// A box of sides a, b, c that turns about its own axis along c: E = m (a² + b²) ω² / 24.
TEST(BlockState, OfABoxThatSpinsHasTheEnergyOfItsSpin) {
  const BlockSystem system = floor_and_boxes();
  Frame frame = moved_frame(system, at_rest, at_rest);
  const double angle = 0.4, spin = 3;
  const Mat3 turn = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
  const Vec3 middle(1, 1, 10.5);
  const std::size_t first = system.blocks[0].mesh.nodes.size();
  for (std::size_t n = 0; n < system.blocks[1].mesh.nodes.size(); ++n) {
    const Vec3 arm = turn * (system.blocks[1].mesh.nodes[n] - middle);
    frame.displacement[first + n] = middle + arm - system.blocks[1].mesh.nodes[n];
    frame.velocity[first + n] = Vec3(0, 0, spin).cross(arm);
  }
  const BlockState slab = BlockWatch(system, {2600}).states(frame, slab_and_tower)[0];
  EXPECT_NEAR(slab.rotation, degrees(angle), 1e-6);
  EXPECT_NEAR(slab.velocity.norm(), 0, 1e-12);
  EXPECT_NEAR(slab.kinetic_energy, 2600 * 4 * (4 + 4) * spin * spin / 24, 1e-6);
}

TEST(BlockState, HasTheForcesOfItsContactsFromBothSides) {
  const BlockSystem system = floor_and_boxes();
  Frame frame = moved_frame(system, at_rest, at_rest);
  ContactSample contact{};
  contact.position = Vec3::Zero();
  contact.normal = Vec3::UnitZ();
  contact.normal_force = 100;
  contact.shear_force = Vec3(30, 0, 0);
  contact.blocks[0] = 1;  // the normal points from the second to the first: it bears the slab
  contact.blocks[1] = 0;
  frame.contacts = {contact, contact};
  const std::vector<int> both{1, 0};
  const std::vector<BlockState> states = BlockWatch(system).states(frame, both);
  EXPECT_NEAR((states[0].contact_force - Vec3(60, 0, 200)).norm(), 0, 1e-12);
  EXPECT_NEAR((states[1].contact_force + Vec3(60, 0, 200)).norm(), 0, 1e-12);
  EXPECT_NEAR(states[0].normal_force, 200, 1e-12);
  EXPECT_NEAR(states[0].shear_force, 60, 1e-12);
  EXPECT_TRUE(std::isnan(states[0].kinetic_energy)) << "of no density";
}

TEST(BlockState, HasTheLargestStressInTheBlock) {
  const BlockSystem system = floor_and_boxes();
  Frame frame = moved_frame(system, at_rest, at_rest);
  frame.stress[6 + 3][2] = -5e6;  // uniaxial, in the slab
  EXPECT_NEAR(BlockWatch(system).states(frame, slab_and_tower)[0].stress, 5e6, 1e-3);
  EXPECT_EQ(BlockWatch(system).states(frame, slab_and_tower)[1].stress, 0);
}

TEST(BlockQuantity, OfAnotherNameIsRefusedWithTheNames) {
  try {
    block_quantity_named("velocity");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("speed"));
  }
}

TEST(BlockHistory, IsATableWithUnitsInItsHeads) {
  BlockHistory history;
  history.names = {"B, \"1\"", "tower"};
  history.times = {0, 0.5};
  history.blocks = slab_and_tower;
  history.of_block.assign(2, std::vector<BlockState>(2));
  history.of_block[0][1].velocity = {0, 3, 4};
  const std::vector<BlockQuantity> wanted{block_quantity_named("speed")};
  EXPECT_EQ(history_csv(history, wanted), "time [s],\"B, \"\"1\"\".speed [m/s]\",tower.speed [m/s]\n0,0,0\n0.5,5,0\n");
}

}  // namespace
}  // namespace talus
