#include <gmock/gmock.h>

#include "rock.hpp"

namespace talus {
namespace {

using namespace rock;
using testing::HasSubstr;
using testing::StartsWith;

Project cube_of_10_m() {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, 5)};
  return p;
}

TEST(Refusal, ACutThatMissesIsNamed) {
  Project p = cube_of_10_m();
  p.cuts = {cut("J1", 0, 0, {0, 0, 5}), cut("J2", 30, 90, {0, 0, 40})};
  EXPECT_EQ(error_of(p), "cut 2 (J2): misses every solid; move its point \"through\", or remove it");
  // Touching an edge divides nothing and lies on no facet.
  p.cuts = {cut("J2", 45, 90, {10, 5, 10})};
  EXPECT_THAT(error_of(p), StartsWith("cut 1 (J2): misses every solid"));
  // It passes through the other solid, which it is not meant for.
  p.solids.push_back(box("other", {0, 0, 20}, {10, 10, 30}, 5));
  p.cuts = {cut("J3", 0, 0, {0, 0, 5})};
  p.cuts[0].solids = {"other"};
  EXPECT_THAT(error_of(p), StartsWith("cut 1 (J3): misses every solid it is limited to"));
}

TEST(Refusal, OverlappingSolidsAreNamedWithThePlace) {
  Project p = cube_of_10_m();
  p.solids.push_back(box("other", {8, 8, 9}, {20, 20, 20}, 5));
  const std::string error = error_of(p);
  EXPECT_THAT(error, StartsWith("solid cube: overlaps solid other by 4 m³ around (9, 9, 9.5); "));
  p.solids[1] = box("inside", {4, 4, 4}, {5, 5, 5}, 1);
  EXPECT_THAT(error_of(p), StartsWith("solid cube: overlaps solid inside by 1 m³"));
  p.solids[1] = box("twin", {0, 0, 0}, {10, 10, 10}, 5);
  EXPECT_THAT(error_of(p), StartsWith("solid cube: overlaps solid twin by 1000 m³"));
}

TEST(Refusal, TouchingSolidsAreNoOverlap) {
  Project p = cube_of_10_m();
  p.solids.push_back(box("face", {10, 0, 0}, {12, 5, 5}, 5));
  p.solids.push_back(box("edge", {-3, 2, 10}, {0, 5, 12}, 5));
  p.solids.push_back(box("corner", {-3, -3, -3}, {0, 0, 0}, 5));
  p.solids.push_back(box("rounded", {2, 2, 9.99999}, {5, 5, 12}, 5));
  EXPECT_EQ(build(p).blocks.size(), 5u);
}

TEST(Refusal, TwoJointsOnOnePlane) {
  Project p = cube_of_10_m();
  p.cuts = {cut("J1", 0, 0, {0, 0, 5}), cut("J2", 0, 0, {3, 3, 5})};
  EXPECT_THAT(error_of(p), StartsWith("cut 2 (J2): lies on the same plane of solid cube as cut 1 (J1); "));
}

TEST(Refusal, ASplinterIsShown) {
  Project p = cube_of_10_m();
  p.splinters.rule = SplinterRule::refuse;
  p.cuts = {cut("J1", 45, 90, {10, 5, 9.9999})};
  EXPECT_THAT(error_of(p), AllOf(StartsWith("solid cube: the cuts leave a splinter "), HasSubstr("around (")));
}

TEST(Refusal, PolyhedraThatAreNoBody) {
  PolyhedronShape tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                              {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  Project p = project();
  p.solids = {solid("tet", tetrahedron, 1)};
  EXPECT_NEAR(build(p).blocks[0].volume, 1.0 / 6, 1e-12);

  PolyhedronShape two = tetrahedron;
  for (std::size_t v = 0; v < 4; ++v) two.vertices.push_back(tetrahedron.vertices[v] + Vec3(5, 5, 5));
  for (const auto& face : tetrahedron.faces) two.faces.push_back({face[0] + 4, face[1] + 4, face[2] + 4});
  p.solids = {solid("two", two, 1)};
  EXPECT_THAT(error_of(p), StartsWith("solid two: face 4 is not joined to face 0; "));

  PolyhedronShape open = tetrahedron;
  open.faces[3] = {0, 2, 3};
  p.solids = {solid("open", open, 1)};
  EXPECT_THAT(error_of(p), StartsWith("/solids/0/polyhedron"));
}

TEST(Refusal, OverridesInNoBlockOrInOneTwice) {
  Project p = cube_of_10_m();
  p.cuts = {cut("J1", 0, 0, {0, 0, 5})};
  p.blocks = {{"B", {5, 5, 11}, {}, {}, {}}};
  EXPECT_EQ(error_of(p),
            "block override 1 (B): its point \"at\" lies in no block; move it inside the block that is meant");
  p.blocks = {{"B", {5, 5, 5}, {}, {}, {}}};
  EXPECT_THAT(error_of(p),
              StartsWith("block override 1 (B): its point \"at\" lies on the border of cube.1 and cube.2"));
  p.blocks = {{"B", {5, 5, 6}, {}, {}, {}}, {"C", {4, 4, 7}, {}, {}, {}}};
  EXPECT_THAT(error_of(p), StartsWith("block override 2 (C): lies in the same block as block override 1 (B); "));
  p.blocks = {{"cube.1", {5, 5, 6}, {}, {}, {}}};
  EXPECT_THAT(error_of(p), StartsWith("block cube.1: two blocks have this name; "));
}

/// What is found once blocks are cut is not found only once they are meshed, which here takes minutes.
TEST(Refusal, AMonitorFarFromItsBlockBeforeItIsMeshed) {
  Project p = cube_of_10_m();
  p.solids[0].mesh_size = 0.1;
  p.cuts = {cut("J1", 0, 0, {0, 0, 5})};
  p.monitors = {{"P1", "cube.1", {5, 5, 5.1}}};
  EXPECT_EQ(error_of(p), "monitor 'P1': the point lies outside block 'cube.1'; choose a point inside the block");
}

TEST(Refusal, ASolidLargerThanTheEarth) {
  Project p = cube_of_10_m();
  p.solids.push_back(box("far", {0, 0, 20}, {10, 2147483648.0, 30}, 5));
  EXPECT_EQ(error_of(p),
            "solid far: is 2.1e+09 m large, more than the Earth; correct its corners, and give them in metres");
}

TEST(Refusal, AMonitorOnABlockThatCuttingDidNotMake) {
  Project p = cube_of_10_m();
  p.cuts = {cut("J1", 0, 0, {0, 0, 5})};
  p.monitors = {{"P1", "cube.3", {1, 1, 1}}};
  EXPECT_THAT(error_of(p), testing::AllOf(StartsWith("/monitors/0/block"), HasSubstr("'cube.1'")));
}

}  // namespace
}  // namespace talus
