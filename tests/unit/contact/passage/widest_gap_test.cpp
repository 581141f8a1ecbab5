#include "contact/passage/widest_gap.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/solver_scenes.hpp"

namespace talus {
namespace {

/// Blocks as a solver has them.
struct BuiltBlocks {
  explicit BuiltBlocks(std::vector<Block> blocks)
      : project(test::rock_project(30, {{"run", StageKind::dynamic, 0.01, 1, {}}})),
        system(test::block_system(std::move(blocks))),
        set(project, system) {
    for (const Block& block : system.blocks) surfaces.push_back(make_surface(block.mesh.nodes, block.surface));
  }
  Project project;
  BlockSystem system;
  BodySet set;
  std::vector<Surface> surfaces;
};

Block rigid_box(const Vec3& half, const Mat3& turn, const Vec3& centre) {
  Block block = test::box_block("B", -half, half, BodyKind::rigid);
  for (Vec3& node : block.mesh.nodes) node = turn * node + centre;
  return block;
}

/// A box where it is; all have one shape, which outlives them.
PlacedPiece placed(const Block& block) {
  static const BuiltBlocks scene({rigid_box({1, 1, 1}, Mat3::Identity(), {0, 0, 0})});
  static const ConvexPieces pieces(scene.system, scene.set, scene.surfaces);
  PlacedPiece piece;
  piece.place(pieces.piece(0, 0), [&](int node) { return block.mesh.nodes[node]; });
  return piece;
}

constexpr double any = std::numeric_limits<double>::infinity();

TEST(ConvexPieces, TakeTheCornersOfABoxAndTheTetrahedraOfWhatDeforms) {
  const BuiltBlocks scene({test::box_block("wall", {0, 0, 0}, {1, 2, 3}, BodyKind::fixed),
                           test::box_block("soft", {4, 0, 0}, {5, 1, 1}, BodyKind::tetrahedra)});
  const ConvexPieces pieces(scene.system, scene.set, scene.surfaces);
  ASSERT_EQ(pieces.count(0), 1);
  const ConvexPiece whole = pieces.piece(0, 0);
  EXPECT_EQ(whole.nodes.size(), 8u);
  EXPECT_EQ(whole.shape->faces.size(), 6u) << "not the triangles";
  EXPECT_EQ(whole.shape->edges.size(), 12u) << "without the diagonals";
  EXPECT_EQ(pieces.count(1), 6);
  EXPECT_EQ(pieces.piece(1, 5).nodes.size(), 4u);
  EXPECT_NEAR(pieces.thickness(1), 1.0 / 3, 1e-12) << "2 V / A";
}

TEST(WidestGap, OfTwoBoxesIsThatOfTheirFaces) {
  const PlacedPiece box = placed(rigid_box({1, 1, 1}, Mat3::Identity(), {0, 0, 0}));
  const Gap apart = widest_gap(box, placed(rigid_box({1, 1, 1}, Mat3::Identity(), {2.5, 1, 0})), any);
  EXPECT_NEAR(apart.width, 0.5, 1e-12);
  EXPECT_NEAR(apart.direction.x(), 1, 1e-12);
  const Gap deep = widest_gap(box, placed(rigid_box({1, 1, 1}, Mat3::Identity(), {0.3, 0, -1.75})), any);
  EXPECT_NEAR(deep.width, -0.25, 1e-12);
  EXPECT_NEAR(deep.direction.z(), -1, 1e-12) << "from the first to the second";
}

TEST(WidestGap, OfTwoRodsThatCrossIsAcrossTheirEdges) {
  const Mat3 upright = Eigen::AngleAxisd(M_PI / 4, Vec3::UnitX()).toRotationMatrix();
  const Mat3 across = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ()).toRotationMatrix() * upright;
  const double height = 0.1 * std::sqrt(2.0);  // of an edge above the axis of a rod
  const Gap gap = widest_gap(placed(rigid_box({2, 0.1, 0.1}, upright, {0, 0, 0})),
                             placed(rigid_box({2, 0.1, 0.1}, across, {0, 0, 2 * height + 0.05})), any);
  EXPECT_NEAR(gap.width, 0.05, 1e-12);
  EXPECT_NEAR(std::abs(gap.direction.z()), 1, 1e-12);
}

TEST(WidestGap, IsWiderThanAlongAnyOtherDirection) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  const auto turn = [&] {
    return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
        .normalized()
        .toRotationMatrix();
  };
  int deep = 0;
  for (int pair = 0; pair < 200; ++pair) {
    const Vec3 half(0.2 + 0.1 * (pair % 5), 0.3, 0.05 + 0.1 * (pair % 3)), centre = 0.3 * vector();
    const Mat3 turned = turn();
    const PlacedPiece first = placed(rigid_box({0.3, 0.4, 0.5}, turn(), {0, 0, 0}));
    const Gap gap = widest_gap(first, placed(rigid_box(half, turned, centre)), any);
    deep += gap.width < 0;
    const PlacedPiece second = placed(rigid_box(half, turned, centre));
    EXPECT_NEAR(gap_along(gap.direction, first, second), gap.width, 1e-12);
    for (int i = 0; gap.width < 0 && i < 500; ++i)
      EXPECT_LE(gap_along(vector().normalized(), first, second), gap.width + 1e-12);
    const Vec3 apart = centre - gap.width * gap.direction;
    EXPECT_NEAR(widest_gap(first, placed(rigid_box(half, turned, apart)), any).width, 0, 1e-9)
        << "moved by so much they touch";
  }
  EXPECT_GT(deep, 50);
  EXPECT_LT(deep, 195);
}

TEST(WidestGap, StopsWhereItIsWideEnough) {
  const PlacedPiece box = placed(rigid_box({1, 1, 1}, Mat3::Identity(), {0, 0, 0}));
  const PlacedPiece other = placed(rigid_box({1, 1, 1}, Mat3::Identity(), {2.1, 3, 0}));
  EXPECT_GT(widest_gap(box, other, 0.05).width, 0.05);
  EXPECT_NEAR(widest_gap(box, other, any).width, 1, 1e-12);
}

}  // namespace
}  // namespace talus
