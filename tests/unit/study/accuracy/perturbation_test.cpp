#include "study/accuracy/perturbation.hpp"

#include <gtest/gtest.h>

namespace talus {
namespace {

Project thrown_and_pulled() {
  Project project;
  project.gravity = {0, 0, -9.81};
  project.velocities = {{"B", Vec3(3, 0, 4), Vec3::Zero()}};
  project.loads = {{"B", Vec3::Zero(), Vec3::Zero(), {{0, Vec3::Zero()}, {1, Vec3(0, 0, 100)}}}};
  return project;
}

TEST(Perturbation, LeavesTheFirstRunAsItIs) { EXPECT_EQ(perturbed(thrown_and_pulled(), 0), thrown_and_pulled()); }

TEST(Perturbation, IsTheSameForTheSameRepeatAndAnotherForEachOther) {
  const Project given = thrown_and_pulled();
  EXPECT_EQ(perturbed(given, 1), perturbed(given, 1));
  EXPECT_NE(perturbed(given, 1), perturbed(given, 2));
  Project other = given;
  other.solver.integrator = Integrator::generalized_alpha;
  EXPECT_EQ(perturbed(other, 1).gravity, perturbed(given, 1).gravity) << "under every setting";
}

TEST(Perturbation, ChangesAMillionthOfSizeAndDirectionAndNothingElse) {
  const Project given = thrown_and_pulled();
  for (int repeat = 1; repeat < 20; ++repeat) {
    Project changed = perturbed(given, repeat);
    for (const auto& [now, before] : {std::pair(changed.gravity, given.gravity),
                                      {changed.velocities[0].linear, given.velocities[0].linear},
                                      {changed.loads[0].table[1].value, given.loads[0].table[1].value}}) {
      EXPECT_GT((now - before).norm(), 0);
      EXPECT_LE((now - before).norm(), std::sqrt(3.0) * 1e-6 * before.norm());
    }
    EXPECT_NE(changed.gravity.x(), 0) << "in direction, too";
    EXPECT_EQ(changed.velocities[0].angular, Vec3::Zero()) << "what is not there stays so";
    changed.gravity = given.gravity;
    changed.velocities = given.velocities;
    changed.loads = given.loads;
    EXPECT_EQ(changed, given);
  }
}

}  // namespace
}  // namespace talus
