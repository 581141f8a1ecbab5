#include "model/solid_shape.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "model/place.hpp"
#include "model/polyhedron.hpp"

namespace talus {
namespace {

double volume_of(const SolidShape& shape) {
  Solid solid;
  solid.shape = shape;
  const auto faces = polyhedron_of(solid);
  EXPECT_TRUE(faces);
  validate_polyhedron(*faces, Place());  // closed, plane, outwards
  return signed_volume(*faces);
}

TEST(SolidShapeTest, ACylinderIsTheRegularPrismInsideIt) {
  const CylinderShape cylinder{{1, 2, 3}, {4, 6, 3}, 2, 12};  // 5 m long
  EXPECT_NEAR(volume_of(cylinder), 5 * 12 * 0.5 * 4 * std::sin(2 * std::numbers::pi / 12), 1e-12);
}

TEST(SolidShapeTest, ASectionIsExtrudedWhicheverWayItsCornersRun) {
  SectionShape section{{{0, 0}, {20, 0}, {20, 10}, {10, 10}}, {100, 50, 7}, 90, 6};
  EXPECT_NEAR(volume_of(section), 6 * 150, 1e-9);
  std::reverse(section.points.begin(), section.points.end());
  EXPECT_NEAR(volume_of(section), 6 * 150, 1e-9);
}

TEST(SolidShapeTest, TheDistanceOfASectionGrowsTowardsItsAzimuth) {
  Solid solid;
  solid.shape = SectionShape{{{0, 0}, {20, 0}, {20, 10}}, {100, 50, 7}, 90, 6};  // to the east
  const BoxShape extent = extent_of({solid}).value();
  EXPECT_TRUE(extent.min.isApprox(Vec3(100, 47, 7)));
  EXPECT_TRUE(extent.max.isApprox(Vec3(120, 53, 17)));
}

TEST(SolidShapeTest, IsTurnedByTheRightHandAndThenMoved) {
  Solid solid;
  solid.shape = BoxShape{{0, 0, 0}, {2, 1, 1}};
  solid.turn = Turn{{0, 0, 5}, 90, {0, 0, 0}};
  solid.move = {10, 0, 0};
  const BoxShape extent = extent_of({solid}).value();
  EXPECT_TRUE(extent.min.isApprox(Vec3(9, 0, 0)));
  EXPECT_TRUE(extent.max.isApprox(Vec3(10, 2, 1)));
}

TEST(SolidShapeTest, FilesTellTheirPathAndNoExtent) {
  Solid hill, land;
  hill.shape = FileShape{"hill.step", 1};
  land.shape = TerrainShape{"land.asc", 0, 0};
  EXPECT_EQ(*file_of(hill.shape), "hill.step");
  EXPECT_EQ(*file_of(land.shape), "land.asc");
  EXPECT_EQ(file_of(SolidShape(BoxShape{{0, 0, 0}, {1, 1, 1}})), nullptr);
  EXPECT_FALSE(extent_of({hill, land}));
}

}  // namespace
}  // namespace talus
