#include <gmock/gmock.h>

#include "rock.hpp"

/// How finely a block is meshed follows from its body, and 'auto' is a body once the blocks are cut.
namespace talus {
namespace {

using namespace rock;
using testing::HasSubstr;
using testing::IsEmpty;

/// Three blocks that are cut from a bench slope of 100 m: base, middle, crest.
Project benches(BodyKind body) {
  Project p = project();
  p.solids = {solid("slope", bench_slope(60))};
  p.solids[0].body = body;
  p.cuts = {cut("J1", 20, 90, {0, 0, 50}), cut("J2", 35, 60, {0, 0, 85})};
  p.blocks = {{"base", {90, 30, 10}, {}, {}, {}}, {"crest", {5, 30, 98}, {}, {}, {}}};
  return p;
}
constexpr double benches_volume = bench_slope_area * 60;

TEST(Bodies, RigidAndAffineBlocksAreMeshedFromTheirCorners) {
  const std::size_t fine = block(build(benches(BodyKind::tetrahedra)), "base").mesh.nodes.size();
  for (const BodyKind body : {BodyKind::rigid, BodyKind::affine}) {
    const BlockSystem system = build(benches(body));
    expect_sound(system, benches_volume);
    for (const Block& block : system.blocks) {
      EXPECT_EQ(block.body, body);
      EXPECT_THAT(block.body_reason, IsEmpty());
    }
    EXPECT_LT(block(system, "base").mesh.nodes.size(), 40u);
    for (const Block& block : system.blocks) EXPECT_TRUE(block.stands_on_corners);
    EXPECT_GT(fine, 10 * block(system, "base").mesh.nodes.size());
  }
}

TEST(Bodies, NeighboursFromTheirCornersHaveEqualTrianglesOnTheJoint) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10})};
  p.solids[0].body = BodyKind::rigid;
  p.cuts = {cut("J1", 30, 90, {5, 5, 5})};
  const BlockSystem system = build(p);
  const auto centres = [&](const Block& block) {
    std::set<std::array<long, 3>> cells;
    for (const auto& triangle : block.surface) {
      if (triangle.joint != 0) continue;
      Vec3 sum = Vec3::Zero();
      for (const int node : triangle.nodes) sum += block.mesh.nodes[node];
      cells.insert({std::lround(1e6 * sum.x()), std::lround(1e6 * sum.y()), std::lround(1e6 * sum.z())});
    }
    return cells;
  };
  EXPECT_EQ(centres(system.blocks[0]).size(), 2u);
  EXPECT_EQ(centres(system.blocks[0]), centres(system.blocks[1]));
  for (const Block& block : system.blocks) {
    std::set<int> on_surface;
    for (const auto& triangle : block.surface) on_surface.insert(triangle.nodes.begin(), triangle.nodes.end());
    EXPECT_EQ(on_surface.size(), 8u);
  }
}

TEST(Bodies, AGivenMeshSizeIsKept) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, 2)};
  const std::size_t nodes = build(p).blocks[0].mesh.nodes.size();
  p.solids[0].body = BodyKind::rigid;
  EXPECT_EQ(build(p).blocks[0].mesh.nodes.size(), nodes);
  p.solids[0].mesh_size.reset();
  EXPECT_EQ(build(p).blocks[0].mesh.nodes.size(), 9u) << "corners and centroid";
  p.blocks = {{"cube too", {5, 5, 5}, {}, {}, 2.0}};
  EXPECT_EQ(build(p).blocks[0].mesh.nodes.size(), nodes);
}

/// Where a thin piece begins does not hang on the body, nor do the names.
TEST(Bodies, CutsDoNotKnowThem) {
  for (const BodyKind body : {BodyKind::tetrahedra, BodyKind::rigid}) {
    Project p = project();
    p.solids = {box("cube", {0, 0, 0}, {10, 10, 10})};
    p.solids[0].body = body;
    p.cuts = {cut("J1", 0, 0, {0, 0, 5}), cut("J2", 0, 0, {0, 0, 5.00005})};
    EXPECT_THAT(error_of(p), HasSubstr("lies on the same plane of solid cube")) << to_string(body);
    p.cuts[1].through.z() = 5.002;
    const BlockSystem system = build(p);
    ASSERT_EQ(system.blocks.size(), 3u) << to_string(body);
    EXPECT_EQ(system.blocks[1].name, "cube.2");
    expect_sound(system, 1000);
  }
}

TEST(Bodies, AutoIsChosenByTheNamesOfTheCutBlocks) {
  Project p = benches(BodyKind::automatic);
  p.constraints = {Constraint{"base", {}}};
  p.monitors = {{"P1", "slope.1", {40, 30, 55}, true}};
  const BlockSystem system = build(p);
  expect_sound(system, benches_volume);
  const auto says = [&](const char* name, BodyKind body, const char* words) {
    EXPECT_EQ(to_string(block(system, name).body), to_string(body)) << name;
    EXPECT_THAT(block(system, name).body_reason, HasSubstr(words)) << name;
  };
  says("base", BodyKind::fixed, "a constraint moves it as a whole");
  says("slope.1", BodyKind::tetrahedra, "monitor P1 asks for its stress");
  // 2600 · 9.81 · 100 / 25e9, by the height of the whole model
  says("crest", BodyKind::affine, "the model's weight strains it by 1e-4");
  EXPECT_GT(block(system, "slope.1").mesh.nodes.size(), 100u);
  EXPECT_LT(block(system, "crest").mesh.nodes.size(), 40u);
}

TEST(Bodies, AnOverrideOfAutoGoesByItsOwnMaterial) {
  Project p = benches(BodyKind::tetrahedra);
  p.materials.push_back({"hard rock", 2600, 1e12, 0.2});
  p.blocks[1].body = BodyKind::automatic;
  p.blocks[1].material = "hard rock";
  const BlockSystem system = build(p);
  EXPECT_EQ(block(system, "crest").body, BodyKind::rigid);
  EXPECT_THAT(block(system, "crest").body_reason, HasSubstr("strains it by 2.6e-6"));
  EXPECT_EQ(block(system, "base").body, BodyKind::tetrahedra);
  EXPECT_THAT(block(system, "base").body_reason, IsEmpty());
}

TEST(Bodies, WhatABodyCannotDoIsSaidBeforeMeshing) {
  Project p = benches(BodyKind::automatic);
  p.constraints = {Constraint{"base", {}}};
  p.monitors = {{"P1", "base", {90, 30, 10}, true}};
  EXPECT_THAT(error_of(p), AllOf(HasSubstr("/monitors/0/stress"), HasSubstr("'fixed' and has no stress")));
}

TEST(Bodies, BlocksServeAProjectThatBuildsAlike) {
  const Project p = benches(BodyKind::tetrahedra);
  const auto changed = [](Project project, const auto& change) {
    change(project);
    return project;
  };
  const auto softer = [](Project& q) { q.materials[0].young = 1e8; };
  const auto slippery = [](Project& q) { q.joints[0].friction_angle = 5; };
  const auto rigid = [](Project& q) { q.solids[0].body = BodyKind::rigid; };
  EXPECT_TRUE(build_alike(p, p));
  EXPECT_TRUE(build_alike(p, changed(p, softer)));
  EXPECT_FALSE(build_alike(p, changed(p, rigid)));
  const Project open = benches(BodyKind::automatic);
  EXPECT_TRUE(build_alike(open, changed(open, slippery)));
  EXPECT_FALSE(build_alike(open, changed(open, softer))) << "the choice may fall otherwise";
}

}  // namespace
}  // namespace talus
