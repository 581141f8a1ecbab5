#include "verification/hard_cases/shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/surface.hpp"
#include "verification/hard_cases/voronoi.hpp"

namespace talus {
namespace {

/// Every shape is a mesh without folds in a surface that is closed, of the volume that its formula says.
void expect_body(const TetMesh& mesh, double expected_volume) {
  for (const auto& t : mesh.tetrahedra) EXPECT_GT(volume({mesh.nodes, {t}}), 0);
  EXPECT_NO_THROW(make_surface(mesh.nodes, boundary(mesh)));
  EXPECT_NEAR(volume(mesh), expected_volume, 1e-12 * expected_volume);
}

TEST(Shapes, HaveTheVolumeOfTheirFormulaAndAClosedSurface) {
  expect_body(spike(1, 3), 1.0 / 3 * 3);
  expect_body(wedge(1, 2, 3), 1.0 / 2 * 2 * 3);
  expect_body(cube(0.4), 0.064);
  expect_body(prism(6, 2, 0.5), 6 * std::sqrt(3.0) / 4 * 4 * 0.5);
  expect_body(slotted_box(0.5, 1, 2, 1, 0.5), 4 * 2 * 1.5 - 0.5 * 2 * 1);
  // A ring of eight pieces: eight trapezia between its corners.
  expect_body(ring(2, 0.5, 8), 8 * std::sqrt(0.5) / 2 * (2.5 * 2.5 - 2 * 2) * 0.5);
  expect_body(hook(2, 3, 0.8), 4 + 3 + 0.8);
  expect_body(holed_box(0.5, 1, 2, 0.5), 4 * 4 * 1.5 - 0.5 * 0.5 * 1);
}

TEST(Shapes, AreMovedWithWhatHangsOnThem) {
  CaseScene scene;
  scene.add_block("cube", cube(1), BodyKind::tetrahedra);
  scene.project.stages.resize(1);
  scene.project.stages[0].loads = {{.block = "cube", .at = {0, 0, 0.5}}};
  shift_scene(scene, {1e6, 2, 3});
  EXPECT_EQ(scene.system.blocks[0].mesh.nodes[0], Vec3(1e6 - 0.5, 1.5, 2.5));
  EXPECT_EQ(scene.project.stages[0].loads->front().at, Vec3(1e6, 2, 3.5));
}

TEST(Voronoi, APlaneTakesAwayWhatLiesBeyondIt) {
  const CuttingPlane diagonal{{1, 0, 0}, Vec3(1, 0, 1).normalized()};
  double sum = 0;
  for (const TetMesh& piece : voronoi_pieces(Vec3::Zero(), Vec3::Ones(), 30, 5, diagonal)) {
    expect_body(piece, volume(piece));
    sum += volume(piece);
    for (const Vec3& node : piece.nodes) EXPECT_LE(node.x() + node.z(), 1 + 1e-15);
  }
  EXPECT_NEAR(sum, 0.5, 1e-14);
}

TEST(Voronoi, PiecesAreSolidAndFillTheBox) {
  const std::vector<TetMesh> pieces = voronoi_pieces({-2, 0, 0}, {2, 0.4, 3}, 100, 5);
  ASSERT_EQ(pieces.size(), 100u);
  double sum = 0;
  for (const TetMesh& piece : pieces) {
    expect_body(piece, volume(piece));
    sum += volume(piece);
  }
  EXPECT_NEAR(sum, 4 * 0.4 * 3, 1e-12);
}

}  // namespace
}  // namespace talus
