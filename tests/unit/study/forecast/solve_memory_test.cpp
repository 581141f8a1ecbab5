#include <gtest/gtest.h>

#include <cstdio>

#include "base/resident_memory.hpp"
#include "base/temporary_folder.hpp"
#include "geometry/block_builder.hpp"
#include "io/project_file.hpp"
#include "run/run.hpp"
#include "study/forecast/run_beginning.hpp"
#include "support/in_a_child.hpp"
#include "support/silent_observer.hpp"

// What solving holds at most, told before, against what a run then holds.
namespace talus {
namespace {

/// A cube on a slab, cut `count` times each way.
Project cut_cube(BodyKind body, int count, double size, int steps) {
  Project project;
  project.name = "cut cube";
  project.materials = {{"rock", 2600, 25e9, 0.24}};
  Joint joint;
  joint.name = "J";
  joint.friction_angle = 30;
  project.joints = {joint};
  project.default_joint = "J";
  Solid slab, cube;
  slab.name = "slab";
  slab.shape = BoxShape{{-1, -1, -1}, {11, 11, 0}};
  slab.body = BodyKind::fixed;
  cube.name = "cube";
  cube.shape = BoxShape{{0, 0, 0}, {10, 10, 10}};
  cube.body = body;
  if (body == BodyKind::tetrahedra) cube.mesh_size = size;
  for (Solid* solid : {&slab, &cube}) solid->material = "rock";
  project.solids = {slab, cube};
  const double spacing = 10.0 / (count + 1);
  for (const auto& [dip, direction] : {std::pair(0.0, 0.0), std::pair(90.0, 90.0), std::pair(90.0, 0.0)}) {
    Cut cut;
    cut.joint = "J";
    cut.dip = dip;
    cut.dip_direction = direction;
    cut.through = Vec3::Constant(spacing);
    cut.spacing = spacing;
    cut.count = count;
    cut.solids = {"cube"};
    project.cuts.push_back(cut);
  }
  Stage stage;
  stage.name = "rest";
  stage.time_step = 0.001;
  stage.steps = steps;
  project.stages = {stage};
  return project;
}

void expect_told_ahead(const char* what, const Project& project) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers hold memory of their own";
#endif
  constexpr double within = 1.3, budget = 2;  // s: the first step is in it on a busy machine too
  NoProgress nobody;
  const BlockSystem system = build_blocks(project, ".", nobody);
  const double told = test::in_a_child([&] { return run_beginning(project, system, budget, nobody).memory; });
  const double held = test::in_a_child([&] {
    const double before = resident_memory().now;
    const TemporaryFolder results;
    SilentObserver observer;
    run(project, system, {results.path() / "results", write_project(project), 1}, observer);
    return resident_memory().most - before;
  });
  std::printf("%s, %zu blocks: %.0f MB told, %.0f MB held\n", what, system.blocks.size(), told / 1e6, held / 1e6);
  EXPECT_LT(held, within * told) << what;
  EXPECT_GT(held, told / within) << what;
}

TEST(SolveMemory, IsToldForMeshedBlocks) {
  expect_told_ahead("meshed blocks", cut_cube(BodyKind::tetrahedra, 1, 1, 4));
}

TEST(SolveMemory, IsToldForManyRigidBlocks) { expect_told_ahead("rigid blocks", cut_cube(BodyKind::rigid, 5, 0, 20)); }

}  // namespace
}  // namespace talus
