#include "fields/pair_forces.hpp"

#include <gtest/gtest.h>

#include "solve/simulation.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

TEST(PairForces, OfACubeAtRestIsItsWeightUnderItsMiddle) {
  const Project project = test::rock_project(30, {{"rest", StageKind::static_, 0.01, 60, {}}});
  BlockSystem system = test::cube_on_slab();
  system.blocks[1].body = BodyKind::rigid;
  Simulation simulation(project, system);
  while (!simulation.finished()) simulation.step();
  const Frame frame = simulation.frame(0);
  std::vector<Vec3> places;
  for (const ContactSample& contact : frame.contacts) places.push_back(contact.position);
  const std::vector<PairForce> forces = pair_forces(frame, places);
  ASSERT_EQ(forces.size(), 1u);
  const double sign = forces[0].blocks[0] == 1 ? 1 : -1;
  EXPECT_LT((sign * forces[0].force - 2600 * 9.81 * Vec3::UnitZ()).norm(), 1e-3 * 2600 * 9.81);
  EXPECT_LT((forces[0].middle - Vec3(0.5, 0.5, 0)).norm(), 1e-3);
}

}  // namespace
}  // namespace talus
