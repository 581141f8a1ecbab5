#include "solve/local_origin.hpp"

#include <gtest/gtest.h>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

const Vec3 site(4194304, -1048576, 2048);  // powers of two: no node is rounded there

BlockSystem moved(BlockSystem system, const Vec3& by) {
  for (Block& block : system.blocks)
    for (Vec3& node : block.mesh.nodes) node += by;
  return system;
}

Project pushed_cube(const Vec3& by) {
  Project project = test::rock_project(20, {{"slide", StageKind::dynamic, 0.01, 30, {}}});
  project.gravity = test::tilted_gravity(30);
  project.loads = {{"B", by + Vec3(0.5, 0.5, 1), Vec3(0, 2000, 0), {}}};
  project.monitors = {{"P", "B", by + Vec3(1, 1, 1)}};
  project.in_situ = {{{}, Voigt::Zero(), Voigt::Unit(2) * -1000, by.z() + 1}};
  return project;
}

TEST(LocalOrigin, IsThatOfTheProjectWhereTheModelIsNear) {
  EXPECT_EQ(local_origin(test::cube_on_slab()), Vec3::Zero());
  EXPECT_EQ(local_origin(moved(test::cube_on_slab(), {50, 0, 0})), Vec3::Zero());
}

TEST(LocalOrigin, OfAModelFarAwayRoundsNoCoordinate) {
  const Vec3 by(310000.3, 4700000.7, 801.9);
  const BlockSystem far = moved(test::cube_on_slab(), by);
  const Vec3 origin = local_origin(far);
  EXPECT_LT((origin - by).norm(), 30) << "within the model's extent";
  const Project project = test::rock_project(20, {});
  const LocalModel model(project, far);
  for (std::size_t b = 0; b < far.blocks.size(); ++b)
    for (std::size_t n = 0; n < far.blocks[b].mesh.nodes.size(); ++n)
      EXPECT_EQ(model.system().blocks[b].mesh.nodes[n] + origin, far.blocks[b].mesh.nodes[n]);
}

TEST(LocalOrigin, MovesWhatAProjectSaysOfPlaces) {
  Project project = pushed_cube(site);
  project.constraints = {{"B", Vec3(site + Vec3(0, 0, 0))}, {"ground", std::nullopt}};
  project.stages[0].loads = project.loads;
  project.stages[0].constraints = project.constraints;
  const BlockSystem system = moved(test::cube_on_slab(), site);
  const LocalModel model(project, system);
  const Vec3 left = site - model.origin();
  EXPECT_EQ(model.project().loads[0].at, Vec3(left + Vec3(0.5, 0.5, 1)));
  EXPECT_EQ((*model.project().stages[0].loads)[0].at, Vec3(left + Vec3(0.5, 0.5, 1)));
  EXPECT_EQ(*model.project().constraints[0].at, left);
  EXPECT_EQ(*(*model.project().stages[0].constraints)[0].at, left);
  EXPECT_FALSE(model.project().constraints[1].at);
  EXPECT_EQ(model.project().monitors[0].at, Vec3(left + Vec3(1, 1, 1)));
  EXPECT_EQ(model.project().in_situ[0].level, left.z() + 1);
}

TEST(LocalOrigin, LetsABlockMoveFarAwayAsItDoesAtTheOrigin) {
  const Project near = pushed_cube({0, 0, 0}), far = pushed_cube(site);
  const BlockSystem blocks = test::cube_on_slab(), blocks_far = moved(blocks, site);
  Simulation a(near, blocks), b(far, blocks_far);
  while (!a.finished()) {
    a.step();
    b.step();
  }
  const Frame here = a.frame(0), there = b.frame(0);
  EXPECT_GT(here.displacement.back().norm(), 0.05);
  for (std::size_t n = 0; n < here.displacement.size(); ++n)
    EXPECT_LT((here.displacement[n] - there.displacement[n]).norm(), 1e-12);
  ASSERT_EQ(here.contacts.size(), there.contacts.size());
  for (std::size_t i = 0; i < here.contacts.size(); ++i)
    EXPECT_LT((here.contacts[i].position + site - there.contacts[i].position).norm(), 1e-8) << "in the user's grid";
  EXPECT_LT((a.history().monitors[0].displacement - b.history().monitors[0].displacement).norm(), 1e-12);
}

}  // namespace
}  // namespace talus
