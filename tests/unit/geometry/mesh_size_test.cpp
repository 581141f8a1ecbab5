#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "geometry/mesh_estimate.hpp"
#include "rock.hpp"

// How finely blocks are meshed: by project, solid and block, near points, and never by more than is allowed.
namespace talus {
namespace {

using namespace rock;
using testing::HasSubstr;
using testing::StartsWith;

Project cube_meshed_by(std::optional<double> size) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10}, size)};
  return p;
}

double tetrahedra_of(const BlockSystem& system) {
  std::size_t count = 0;
  for (const Block& b : system.blocks) count += b.mesh.tetrahedra.size();
  return static_cast<double>(count);
}

/// m, mean length of the edges of tetrahedra whose middle lies in the shell.
double mean_edge(const Block& b, const Vec3& about, double from, double to) {
  double sum = 0;
  int count = 0;
  for (const auto& t : b.mesh.tetrahedra)
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < i; ++k) {
        const Vec3 &p = b.mesh.nodes[t[i]], &q = b.mesh.nodes[t[k]];
        const double distance = ((p + q) / 2 - about).norm();
        if (distance < from || distance > to) continue;
        sum += (p - q).norm();
        ++count;
      }
  return sum / count;
}

TEST(MeshSize, OfTheProjectIsThatOfSolidsWithoutOne) {
  Project p = cube_meshed_by({});
  p.mesh.size = 2;
  const double by_project = tetrahedra_of(build(p));
  EXPECT_EQ(by_project, tetrahedra_of(build(cube_meshed_by(2))));
  p.solids[0].mesh_size = 5;
  EXPECT_EQ(tetrahedra_of(build(p)), tetrahedra_of(build(cube_meshed_by(5))));
}

TEST(MeshSize, IsThatOfARefinementNearItsPointAndGrowsToTheBlocksOwn) {
  Project p = cube_meshed_by(2);
  const Vec3 corner(10, 10, 10), middle(5, 5, 5);
  p.mesh.refinements = {{corner, 2, 0.4}};
  const Block b = build(p).blocks[0];
  // Edges of tetrahedra inside are longer than what is aimed at: by as much as in a mesh of one size.
  const double usual = mean_edge(build(cube_meshed_by(1)).blocks[0], middle, 0, 5);
  EXPECT_NEAR(mean_edge(b, corner, 0, 2) / usual, 0.4, 0.06);
  EXPECT_NEAR(mean_edge(b, corner, 9, 20) / usual, 2, 0.3);
  const double between = mean_edge(b, corner, 2.5, 3.5) / usual;
  EXPECT_GT(between, 0.55);
  EXPECT_LT(between, 1.5);
  expect_sound(build(p), 1000);
  p.mesh.refinements = {{middle, 1.5, 0.5}};
  EXPECT_NEAR(mean_edge(build(p).blocks[0], middle, 0, 1.5) / usual, 0.5, 0.075)
      << "inside the rock, far from any face";
}

TEST(MeshSize, IsThatOfARefinementNearItsFace) {
  Project p = cube_meshed_by(2);
  p.mesh.refinements = {{.radius = 1.5, .size = 0.6, .face = {{0, 0, 10}, {10, 0, 10}, {10, 10, 10}, {0, 10, 10}}}};
  const Block b = build(p).blocks[0];
  // As a mesh of one size in the same place, be it in a corner or in the middle of the face.
  const Block fine = build(cube_meshed_by(0.6)).blocks[0], coarse = build(cube_meshed_by(2)).blocks[0];
  for (const Vec3& at : {Vec3(5, 5, 10), Vec3(0, 10, 10), Vec3(8, 2, 10)})
    EXPECT_NEAR(mean_edge(b, at, 0, 1.2) / mean_edge(fine, at, 0, 1.2), 1, 0.15) << at.transpose();
  EXPECT_NEAR(mean_edge(b, {5, 5, 0}, 0, 5) / mean_edge(coarse, {5, 5, 0}, 0, 5), 1, 0.15) << "away from it";
  expect_sound(build(p), 1000);
}

TEST(MeshSize, MayBeCoarserNearAPoint) {
  Project p = cube_meshed_by(1);
  p.mesh.refinements = {{Vec3(0, 0, 0), 6, 3}};
  EXPECT_LT(tetrahedra_of(build(p)), 0.7 * tetrahedra_of(build(cube_meshed_by(1))));
  expect_sound(build(p), 1000);
}

TEST(MeshSize, OfARefinementLeavesEqualTrianglesOnBothSidesOfAJoint) {
  Project p = cube_meshed_by(2.5);
  p.cuts = {cut("J1", 35, 90, {5, 5, 5})};
  p.mesh.refinements = {{Vec3(5, 5, 5), 2, 0.5}};
  const BlockSystem system = build(p);
  ASSERT_EQ(system.blocks.size(), 2u);
  std::array<std::set<std::array<double, 3>>, 2> nodes;
  for (std::size_t b = 0; b < 2; ++b)
    for (const SurfaceTriangle& t : system.blocks[b].surface)
      if (t.joint == 0)
        for (int n : t.nodes) {
          const Vec3& at = system.blocks[b].mesh.nodes[n];
          nodes[b].insert({at.x(), at.y(), at.z()});
        }
  EXPECT_GT(nodes[0].size(), 60u);
  EXPECT_EQ(nodes[0], nodes[1]);
}

TEST(MeshSize, OfARigidBlockIsNotRefined) {
  Project p = cube_meshed_by({});
  p.solids[0].body = BodyKind::rigid;
  p.mesh.size = 0.5;
  p.mesh.refinements = {{Vec3(10, 10, 10), 2, 0.2}};
  EXPECT_LE(tetrahedra_of(build(p)), 24);
}

void expect_an_estimate_right_to_a_fifth(const Project& p, const std::filesystem::path& folder = ".") {
  NoProgress nobody;
  const MeshEstimate estimate = mesh_estimate(p, cut_blocks(p, folder, nobody));
  const BlockSystem system = build(p, folder);
  double nodes = 0;
  for (const Block& b : system.blocks) nodes += static_cast<double>(b.mesh.nodes.size());
  std::printf("%zu blocks, size %g m: %.0f tetrahedra of %.0f, %.0f nodes of %.0f\n", system.blocks.size(),
              p.mesh.size.value_or(0), estimate.tetrahedra, tetrahedra_of(system), estimate.nodes, nodes);
  EXPECT_NEAR(estimate.tetrahedra / tetrahedra_of(system), 1, 0.2);
  EXPECT_NEAR(estimate.nodes / nodes, 1, 0.2);
  EXPECT_NEAR(estimate.unknowns, 3 * estimate.nodes, 1e-6);
  // It says the same of blocks that are meshed already.
  EXPECT_NEAR(mesh_estimate(p, system).nodes / estimate.nodes, 1, 0.05);
}

TEST(MeshEstimate, IsRightToAFifthForBlocksOfAQuarterOfAnEdgeToManyAcross) {
  Project p = project();
  p.solids = {box("cube", {0, 0, 0}, {10, 10, 10})};
  p.splinters.rule = SplinterRule::merge;
  p.cuts = {joint_set("J1", 35, 90, {5, 5, 1}, 2, 4), joint_set("J2", 70, 200, {5, 1, 5}, 2.5, 4),
            joint_set("J3", 80, 300, {2, 5, 5}, 2.5, 3)};
  for (const double size : {4.0, 1.0, 0.6}) {
    p.mesh.size = size;
    expect_an_estimate_right_to_a_fifth(p);
  }
}

TEST(MeshEstimate, IsRightToAFifthUnderRoughGround) {
  const auto folder = std::filesystem::temp_directory_path() / ("talus_estimate_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  constexpr int points = 40;
  constexpr double cell = 2.5;
  {
    std::mt19937 random(3);
    std::ofstream grid(folder / "land.asc");
    grid << "ncols " << points << "\nnrows " << points << "\nxllcorner 0\nyllcorner 0\ncellsize " << cell
         << "\nNODATA_value -9999\n";
    for (int row = 0; row < points; ++row)
      for (int column = 0; column < points; ++column)
        grid << 40 * (1 - column * cell / 100) + 3 * std::sin(0.3 * row * cell) + 0.75 * (random() / 4294967296.0)
             << (column == points - 1 ? "\n" : " ");
  }
  Project p = project();
  p.solids = {solid("hill", TerrainShape{"land.asc", -50, 0})};
  p.splinters.rule = SplinterRule::merge;
  p.cuts = {joint_set("J1", 28, 95, {50, 50, -40}, 11, 8), joint_set("J2", 78, 185, {50, 10, 0}, 11, 8),
            joint_set("J3", 72, 280, {90, 50, 0}, 11, 8)};
  for (const double size : {30.0, 9.0, 4.0}) {
    p.mesh.size = size;
    expect_an_estimate_right_to_a_fifth(p, folder);
  }
  std::filesystem::remove_all(folder);
}

TEST(MeshEstimate, KnowsRefinementsAndBodies) {
  Project p = cube_meshed_by(2);
  NoProgress nobody;
  const BlockSystem coarse = cut_blocks(p, ".", nobody);
  EXPECT_LE(tetrahedra_of(coarse), 24);
  p.mesh.refinements = {{Vec3(10, 10, 10), 2, 0.4}};
  EXPECT_NEAR(mesh_estimate(p, coarse).tetrahedra / tetrahedra_of(build(p)), 1, 0.4);
  p.solids[0].body = BodyKind::rigid;
  p.solids[0].mesh_size.reset();
  const MeshEstimate rigid = mesh_estimate(p, cut_blocks(p, ".", nobody));
  EXPECT_EQ(rigid.unknowns, 6);
  EXPECT_LT(rigid.tetrahedra, 50);
}

TEST(MeshEstimate, CountsOneTetrahedronATriangleWhereBlocksStandOnTheirCorners) {
  NoProgress nobody;
  Project p = cube_meshed_by({});
  p.cuts = {joint_set("J1", 35, 90, {5, 5, 1}, 2, 4), joint_set("J2", 70, 200, {5, 1, 5}, 2.5, 4)};
  for (const BodyKind body : {BodyKind::rigid, BodyKind::affine, BodyKind::fixed}) {
    p.solids[0].body = body;
    p.mesh.most_tetrahedra = 1e7;
    const BlockSystem system = build(p);
    const MeshEstimate ahead = mesh_estimate(p, cut_blocks(p, ".", nobody));
    EXPECT_EQ(ahead.tetrahedra, tetrahedra_of(system));
    double nodes = 0;
    for (const Block& b : system.blocks) nodes += static_cast<double>(b.mesh.nodes.size());
    EXPECT_EQ(ahead.nodes, nodes);
    // What is refused before meshing is the same number.
    p.mesh.most_tetrahedra = ahead.tetrahedra;
    EXPECT_EQ(error_of(p), "no error");
    p.mesh.most_tetrahedra = ahead.tetrahedra - 1;
    EXPECT_THAT(error_of(p), StartsWith("/mesh/most_tetrahedra"));
  }
}

TEST(MeshEstimate, OfBlocksThatWereMeshedKnowsThatFixedOnesWillStandOnTheirCorners) {
  Project p = cube_meshed_by(1);
  const BlockSystem fine = build(p);
  p.solids[0].mesh_size.reset();
  p.solids[0].body = BodyKind::fixed;
  EXPECT_EQ(mesh_estimate(p, fine).tetrahedra, 12);
  // Where a joint ends the cube is meshed, and so it is where one of its blocks deforms.
  Project deforms = p;
  deforms.blocks = {{"part", {5, 5, 5}, BodyKind::tetrahedra, {}, {}}};
  EXPECT_GT(mesh_estimate(deforms, fine).tetrahedra, 1000);
  p.cuts = {cut("J1", 35, 90, {5, 5, 5})};
  p.cuts[0].disc = Disc{{5, 5, 5}, 2};
  EXPECT_GT(mesh_estimate(p, fine).tetrahedra, 1000);
}

TEST(MeshEstimate, BeforeMeshingKnowsTheCornersOfTheBlocks) {
  Project p = project();
  p.solids = {solid("shaft", CylinderShape{{0, 0, 0}, {0, 0, 1}, 1, 200}, 2.0)};
  p.mesh.most_tetrahedra = 300;
  EXPECT_THAT(error_of(p), StartsWith("/mesh/most_tetrahedra")) << "400 corners make at least 796 triangles";
}

TEST(MeshEstimate, OfMoreThanIsAllowedIsRefusedAtOnce) {
  // To try it would never end.
  EXPECT_THAT(error_of(cube_meshed_by(1e-6)),
              StartsWith("/mesh/most_tetrahedra: the mesh would have about 4.4e+21 tetrahedra"));
  Project p = cube_meshed_by(1);
  p.mesh.most_tetrahedra = 4000;
  EXPECT_THAT(error_of(p), HasSubstr("tetrahedra, more than 4000; make mesh sizes larger"));
  p.mesh.most_tetrahedra = 8000;
  EXPECT_EQ(error_of(p), "no error");
}

}  // namespace
}  // namespace talus
