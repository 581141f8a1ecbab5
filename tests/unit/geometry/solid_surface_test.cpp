#include "geometry/solid_surface.hpp"

#include <gmock/gmock.h>

#include "rock.hpp"

namespace talus {
namespace {

using namespace rock;

SolidSurface surface_of(const Solid& solid) {
  NoProgress nobody;
  return solid_surface(solid, Vec3::Zero(), ".", nobody);
}

/// By the divergence theorem: right only when the triangles are closed and run outwards.
double volume_within(const SolidSurface& surface) {
  double sum = 0;
  for (const auto& [a, b, c] : surface.triangles)
    sum += (surface.vertices[a] - surface.min)
               .dot((surface.vertices[b] - surface.min).cross(surface.vertices[c] - surface.min)) /
           6;
  return sum;
}

TEST(SolidSurface, OfABoxHasItsCornersAndEdges) {
  const SolidSurface surface = surface_of(box("cube", {1, 2, 3}, {3, 5, 7}));
  EXPECT_EQ(surface.name, "cube");
  EXPECT_EQ(surface.triangles.size(), 12u);
  EXPECT_EQ(surface.edges.size(), 12u);
  EXPECT_DOUBLE_EQ(surface.volume, 24);
  EXPECT_DOUBLE_EQ(volume_within(surface), 24);
  EXPECT_EQ(surface.min, Vec3(1, 2, 3));
  EXPECT_EQ(surface.max, Vec3(3, 5, 7));
  EXPECT_TRUE(surface.closed);
  EXPECT_FALSE(surface.is_part);
}

TEST(SolidSurface, OfFacesThatAreNotConvexClosesAroundTheVolume) {
  const SolidSurface surface = surface_of(solid("slope", bench_slope(30)));
  EXPECT_EQ(surface.triangles.size(), 2 * 8u + 10 * 2u);
  EXPECT_NEAR(volume_within(surface), bench_slope_area * 30, 1e-9 * surface.volume);
}

TEST(SolidSurface, IsTurnedAndMovedAsTheSolidIs) {
  Solid cube = box("cube", {0, 0, 0}, {2, 1, 1});
  cube.turn = Turn{Vec3::UnitZ(), 90, Vec3::Zero()};
  cube.move = {10, 0, 0};
  const SolidSurface surface = surface_of(cube);
  EXPECT_TRUE(surface.min.isApprox(Vec3(9, 0, 0), 1e-12)) << surface.min.transpose();
  EXPECT_TRUE(surface.max.isApprox(Vec3(10, 2, 1), 1e-12)) << surface.max.transpose();
}

TEST(SurfaceFinding, SaysHowManyAndWhatWasDone) {
  using Kind = SurfaceFinding::Kind;
  EXPECT_EQ(text_of({Kind::hole, 3, Vec3::Zero(), true}), "3 holes: filled");
  EXPECT_EQ(text_of({Kind::inside_out, 1, Vec3::Zero(), true}), "1 face inside out: turned");
  EXPECT_TRUE(is_fatal({Kind::self_intersection, 2, Vec3::Zero(), false}));
  EXPECT_FALSE(is_fatal({Kind::hole, 2, Vec3::Zero(), true}));
  EXPECT_FALSE(is_fatal({Kind::tiny_face, 2, Vec3::Zero(), false}));
}

}  // namespace
}  // namespace talus
