#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "solid_files.hpp"

namespace talus {
namespace {

using namespace rock;
using testing::IsEmpty;
using testing::StartsWith;

class CombinedSolids : public SolidFiles {
 protected:
  static Solid combined(CombineOperation operation, const std::vector<std::string>& names) {
    return solid("sum", CombinedShape{operation, names}, 5);
  }
  /// A box, a prism of 24 sides through it, and what they make.
  static std::vector<Solid> tunnel(CombineOperation operation) {
    return {box("rock", {0, 0, 0}, {20, 10, 12}), solid("bore", CylinderShape{{10, -5, 6}, {10, 15, 6}, 3, 24}),
            combined(operation, {"rock", "bore"})};
  }
  std::vector<SolidSurface> surfaces_of(const std::vector<Solid>& solids) const {
    NoProgress nobody;
    return solid_surfaces(project_of(solids), folder(), nobody);
  }
};

/// m², of a regular polygon with corners on the circle.
double polygon_area(double radius, int sides) {
  return sides * radius * radius * std::sin(2 * std::numbers::pi / sides) / 2;
}

const double rock_volume = 20 * 10 * 12, bore_area = polygon_area(3, 24);

TEST_F(CombinedSolids, HaveTheVolumeThatTheirPartsMake) {
  const std::map<CombineOperation, double> volumes{{CombineOperation::subtract, rock_volume - 10 * bore_area},
                                                   {CombineOperation::intersect, 10 * bore_area},
                                                   {CombineOperation::unite, rock_volume + 10 * bore_area}};
  for (const auto& [operation, volume] : volumes) {
    SCOPED_TRACE(to_string(operation));
    const auto surfaces = surfaces_of(tunnel(operation));
    ASSERT_EQ(surfaces.size(), 3u);
    EXPECT_TRUE(surfaces[0].is_part);
    EXPECT_TRUE(surfaces[1].is_part);
    EXPECT_FALSE(surfaces[2].is_part);
    EXPECT_EQ(surfaces[2].name, "sum");
    EXPECT_NEAR(surfaces[2].volume, volume, 1e-9 * volume);
    EXPECT_TRUE(surfaces[2].closed);
    EXPECT_FALSE(surfaces[2].triangles.empty());
  }
}

TEST_F(CombinedSolids, AreBlocksAndTheirPartsAreNone) {
  Project p = project_of(tunnel(CombineOperation::subtract));
  p.solids.push_back(box("beside", {30, 0, 0}, {31, 1, 1}, 1));
  p.cuts = {cut("J1", 45, 90, {4, 5, 6})};
  p.cuts[0].solids = {"sum"};
  const BlockSystem system = build(p, folder());
  ASSERT_EQ(system.blocks.size(), 3u);
  EXPECT_EQ(system.blocks[0].name, "sum.1");
  EXPECT_EQ(system.blocks[1].name, "sum.2");
  EXPECT_EQ(system.blocks[2].name, "beside");
  EXPECT_EQ(system.blocks[0].solid, 2);
  EXPECT_EQ(system.blocks[2].solid, 3);
  expect_sound(system, rock_volume - 10 * bore_area + 1);
}

TEST_F(CombinedSolids, MayHaveTrianglesAmongTheirParts) {
  write_stl("cube.stl", cube_surface());
  const std::vector<Solid> solids{solid("cube", FileShape{"cube.stl"}), box("corner", {5, 5, 5}, {20, 20, 20}),
                                  combined(CombineOperation::subtract, {"cube", "corner"})};
  EXPECT_NEAR(surfaces_of(solids)[2].volume, 875, 1e-9);
  const BlockSystem system = build(project_of(solids), folder());
  ASSERT_EQ(system.blocks.size(), 1u);
  EXPECT_EQ(system.blocks[0].name, "sum");
  expect_sound(system, 875);
}

/// Faces of both lie in one plane here.
TEST_F(CombinedSolids, OfTerrainLoseATunnel) {
  write("plane.xyz", "0 0 20\n30 0 20\n30 30 20\n0 30 20\n15 15 26\n");
  const std::vector<Solid> solids{solid("hill", TerrainShape{"plane.xyz", 0, 0}),
                                  solid("bore", CylinderShape{{15, 0, 6}, {15, 30, 6}, 3, 12}),
                                  combined(CombineOperation::subtract, {"hill", "bore"})};
  const double volume = 900 * 20 + 900 * 6 / 3.0 - 30 * polygon_area(3, 12);
  EXPECT_NEAR(surfaces_of(solids)[2].volume, volume, 1e-9 * volume);
}

TEST_F(CombinedSolids, AreTurnedAndMovedAsAWhole) {
  std::vector<Solid> solids = tunnel(CombineOperation::subtract);
  solids[2].turn = Turn{Vec3::UnitZ(), 90, Vec3::Zero()};
  solids[2].move = {0, 0, 100};
  const auto surfaces = surfaces_of(solids);
  EXPECT_TRUE(surfaces[2].min.isApprox(Vec3(-10, 0, 100), 1e-6)) << surfaces[2].min.transpose();
  EXPECT_TRUE(surfaces[2].max.isApprox(Vec3(0, 20, 112), 1e-6)) << surfaces[2].max.transpose();
  EXPECT_EQ(surfaces[0].min, Vec3(0, 0, 0));
}

TEST_F(CombinedSolids, OfWhichNothingIsLeftAreRefused) {
  Project p = project_of({box("a", {0, 0, 0}, {1, 1, 1}), box("b", {5, 0, 0}, {6, 1, 1}),
                          combined(CombineOperation::intersect, {"a", "b"})});
  EXPECT_EQ(error_of(p, folder()), "solid sum: nothing is left of it; move its parts so that they share rock");
  write_stl("cube.stl", cube_surface());
  p.solids[0] = solid("a", FileShape{"cube.stl"});
  p.solids[1] = box("b", {50, 0, 0}, {60, 1, 1});
  EXPECT_EQ(error_of(p, folder()), "solid sum: nothing is left of it; move its parts so that they share rock");
}

TEST_F(CombinedSolids, OfOpenSurfacesAreRefused) {
  Surface open = cube_surface();
  open.triangles.erase(open.triangles.begin() + 2, open.triangles.begin() + 4);
  write_stl("open.stl", open);
  EXPECT_THAT(error_of(project_of({solid("a", FileShape{"open.stl"}), box("b", {0, 0, 0}, {1, 1, 1}),
                                   combined(CombineOperation::unite, {"a", "b"})}),
                       folder()),
              StartsWith("open.stl: its surface has 1 hole"));
}

TEST_F(CombinedSolids, InSeveralPiecesAreBlocksEach) {
  const Project p = project_of({box("rock", {0, 0, 0}, {9, 3, 3}), box("gap", {4, -1, -1}, {5, 4, 4}),
                                combined(CombineOperation::subtract, {"rock", "gap"})});
  const BlockSystem system = build(p, folder());
  ASSERT_EQ(system.blocks.size(), 2u);
  EXPECT_EQ(system.blocks[0].name, "sum.1");
  expect_sound(system, 72);
  NoProgress nobody;
  EXPECT_EQ(found(solid_surfaces(p, folder(), nobody)[2], SurfaceFinding::Kind::several_bodies), 2);
}

}  // namespace
}  // namespace talus
