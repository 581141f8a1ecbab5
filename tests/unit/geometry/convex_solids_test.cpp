#include <gmock/gmock.h>

#include "rock.hpp"
#include "voronoi_cells.hpp"

// Convex solids whose blocks do not deform are cut as convex cells, without OpenCASCADE: the same promises as for all
// others, and the same blocks.
namespace talus {
namespace {

using namespace rock;
using testing::HasSubstr;
using testing::StartsWith;

Project cube(BodyKind body) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10})};
  p.solids[0].body = body;
  p.cuts = {joint_set("J1", 30, 70, {5, 5, 2}, 2, 3), joint_set("J2", 80, 200, {5, 8, 5}, 2.5, 3),
            cut("J3", 70, 300, {4, 5, 5})};
  return p;
}

TEST(ConvexSolids, GiveTheBlocksThatOpenCascadeGives) {
  const BlockSystem rigid = build(cube(BodyKind::rigid)), meshed = build(cube(BodyKind::tetrahedra));
  expect_sound(rigid, 1000);
  ASSERT_EQ(rigid.blocks.size(), meshed.blocks.size());
  EXPECT_GT(rigid.blocks.size(), 20u);
  for (std::size_t b = 0; b < rigid.blocks.size(); ++b) {
    EXPECT_EQ(rigid.blocks[b].name, meshed.blocks[b].name);
    EXPECT_NEAR(rigid.blocks[b].volume, meshed.blocks[b].volume, 1e-9);
    const auto own = joint_areas(rigid.blocks[b]), other = joint_areas(meshed.blocks[b]);
    ASSERT_EQ(own.size(), other.size()) << rigid.blocks[b].name;
    for (const auto& [joint, area] : own) EXPECT_NEAR(area, other.at(joint), 1e-8);
  }
}

TEST(ConvexSolids, StandOnTheirCornersWhateverTheyAreHeldBy) {
  for (const BodyKind body : {BodyKind::rigid, BodyKind::affine, BodyKind::fixed}) {
    Project p = cube(body);
    p.cuts.clear();
    const BlockSystem system = build(p);
    expect_sound(system, 1000);
    EXPECT_EQ(system.blocks[0].mesh.nodes.size(), 9u) << "its corners and its centroid";
    EXPECT_EQ(system.blocks[0].mesh.tetrahedra.size(), 12u) << "one on each triangle";
  }
}

TEST(ConvexSolids, KeepTheJointOfAPlaneThatLiesOnAFace) {
  Project p = cube(BodyKind::rigid);
  p.cuts = {cut("J1", 0, 0, {0, 0, 5}), cut("J2", 0.05, 90, {5, 5, 10 - 1e-5}), cut("J1", 0, 0, {3, 3, 5})};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 2u);
  EXPECT_NEAR(joint_areas(system.blocks[1])[1], 100, 1e-9);
  p.cuts[2].joint = "J3";
  EXPECT_THAT(error_of(p), StartsWith("cut 3 (J3): lies on the same plane of solid cube as cut 1 (J1)"));
}

TEST(ConvexSolids, MayTouchAndNotOverlap) {
  Project p = cube(BodyKind::rigid);
  p.cuts.clear();
  p.solids.push_back(box("beside", {10, 0, 0}, {12, 10, 10}));
  p.solids.push_back(box("on top", {2, 2, 10}, {4, 4, 12}));
  p.solids[1].body = BodyKind::rigid;  // the other one is meshed
  EXPECT_EQ(build(p).blocks.size(), 3u);
  p.solids[1].move = {-1, 0, 0};
  EXPECT_THAT(error_of(p), StartsWith("solid cube: overlaps solid beside by 100 m³"));
  p.solids[1].move = {0, 0, 0};
  p.solids[2].move = {0, 0, -1};
  EXPECT_THAT(error_of(p), HasSubstr("overlaps solid on top by 4 m³"));
}

/// m, middles of the block's triangles on the plane of a face.
std::vector<Vec3> middles_on(const Block& block, const voronoi::Face& face) {
  const Vec3 normal = (face.corners[1] - face.corners[0]).cross(face.corners[2] - face.corners[0]).normalized();
  std::vector<Vec3> middles;
  for (const SurfaceTriangle& triangle : block.surface) {
    Vec3 sum = Vec3::Zero();
    bool lies_on_it = true;
    for (const int node : triangle.nodes) {
      const Vec3& at = block.mesh.nodes[node];
      sum += at;
      lies_on_it = lies_on_it && std::abs(normal.dot(at - face.corners[0])) < 1e-7;
    }
    if (lies_on_it) middles.push_back(sum / 3);
  }
  return middles;
}

TEST(ConvexSolids, ThatFillABoxAsVoronoiCellsMatchFaceByFace) {
  constexpr int count = 20;
  const Vec3 sides(4, 3, 2);
  const std::vector<voronoi::Cell> cells = voronoi::cells(sides, count, 5);
  Project p = project();
  for (int i = 0; i < count; ++i) {
    p.solids.push_back(solid("cell " + std::to_string(i), voronoi::polyhedron(cells[i])));
    p.solids.back().body = BodyKind::rigid;
  }
  const BlockSystem system = build(p);
  expect_sound(system, sides.prod());
  ASSERT_EQ(system.blocks.size(), static_cast<std::size_t>(count));
  int inner = 0;
  for (int i = 0; i < count; ++i) {
    const Block& own = system.blocks[i];
    EXPECT_EQ(own.mesh.nodes.size(), std::get<PolyhedronShape>(p.solids[i].shape).vertices.size() + 1)
        << "corners and centroid: OpenCASCADE and gmsh had no part in it";
    for (const voronoi::Face& face : cells[i]) {
      const std::vector<Vec3> here = middles_on(own, face);
      EXPECT_EQ(here.size(), face.corners.size() - 2);
      if (face.across < 0) continue;
      ++inner;
      const std::vector<Vec3> there = middles_on(system.blocks[face.across], face);
      EXPECT_EQ(here.size(), there.size());
      for (const Vec3& middle : here)
        EXPECT_TRUE(std::ranges::any_of(there, [&](const Vec3& other) { return (other - middle).norm() < 1e-9; }))
            << own.name << " against " << system.blocks[face.across].name;
    }
  }
  EXPECT_GT(inner, 100);
}

/// Of unit density about the origin: all on which the motion of an affine block depends.
struct Moments {
  double volume = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
};

Moments moments_of(const Block& block) {
  Moments moments;
  for (const auto& tetrahedron : block.mesh.tetrahedra) {
    std::array<Vec3, 4> at;
    for (std::size_t k = 0; k < 4; ++k) at[k] = block.mesh.nodes[tetrahedron[k]];
    const double volume = (at[1] - at[0]).cross(at[2] - at[0]).dot(at[3] - at[0]) / 6;
    const Vec3 sum = at[0] + at[1] + at[2] + at[3];
    moments.volume += volume;
    moments.first += volume * sum / 4;
    moments.second += volume * sum * sum.transpose() / 20;
    for (const Vec3& corner : at) moments.second += volume * corner * corner.transpose() / 20;
  }
  return moments;
}

TEST(ConvexSolids, HaveTheMassAndTheInertiaOfThoseThatAreMeshed) {
  const BlockSystem affine = build(cube(BodyKind::affine)), meshed = build(cube(BodyKind::tetrahedra));
  ASSERT_EQ(affine.blocks.size(), meshed.blocks.size());
  for (std::size_t b = 0; b < affine.blocks.size(); ++b) {
    const Moments own = moments_of(affine.blocks[b]), other = moments_of(meshed.blocks[b]);
    EXPECT_NEAR(own.volume / other.volume, 1, 1e-12);
    EXPECT_LT((own.first - other.first).norm(), 1e-12 * other.first.norm());
    EXPECT_LT((own.second - other.second).norm(), 1e-12 * other.second.norm());
  }
}

TEST(ConvexSolids, AreMeshedWhereABlockDeforms) {
  Project p = cube(BodyKind::rigid);
  p.cuts = {cut("J1", 0, 0, {0, 0, 5})};
  p.blocks = {{"upper", {5, 5, 7}, BodyKind::tetrahedra, {}, {}}};
  const BlockSystem system = build(p);
  expect_sound(system, 1000);
  EXPECT_GT(block(system, "upper").mesh.nodes.size(), 200u);
  EXPECT_LT(system.blocks[0].mesh.nodes.size(), 12u);
}

}  // namespace
}  // namespace talus
