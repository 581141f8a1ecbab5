#include "orientation/fitted_plane.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"

namespace talus {
namespace {

TEST(FittedPlane, OfThreePointsGoesThroughThem) {
  // z falls by as much as x grows: 45° towards the east.
  const std::vector<Vec3> points{{0, 0, 10}, {10, 0, 0}, {5, 8, 5}};
  const FittedPlane fit = fitted_plane(points, "points");
  EXPECT_NEAR(fit.plane.dip, 45, 1e-6);
  EXPECT_NEAR(fit.plane.dip_direction, 90, 1e-6);
  EXPECT_NEAR(fit.deviation, 0, 1e-7);
  const Vec3 pole = pole_of(fit.plane);
  for (const Vec3& point : points) EXPECT_NEAR(pole.dot(point - fit.through), 0, 1e-6);
}

TEST(FittedPlane, FarFromTheOriginIsTheSame) {
  const Vec3 far(512307, 3214880, 1214);
  const std::vector<Vec3> points{far + Vec3(0, 0, 1), far + Vec3(1, 0, 0), far + Vec3(0.5, 2, 0.5)};
  EXPECT_NEAR(fitted_plane(points, "points").plane.dip, 45, 1e-5);
}

TEST(FittedPlane, OfManyPointsIsTheNearestOne) {
  std::vector<Vec3> points;
  for (const double x : {-2.0, -1.0, 0.0, 1.0, 2.0})
    for (const double y : {-2.0, 0.0, 2.0})
      for (const double off : {-0.1, 0.1}) points.push_back({x, y, off});
  const FittedPlane fit = fitted_plane(points, "points");
  EXPECT_NEAR(fit.plane.dip, 0, 1e-6);
  EXPECT_NEAR(fit.deviation, 0.1, 1e-9);
}

TEST(FittedPlane, NeedsThreePointsThatAreNotOnOneLine) {
  EXPECT_THROW(fitted_plane(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}, "points"), InputError);
  EXPECT_THROW(fitted_plane(std::vector<Vec3>{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}, "points"), InputError);
  EXPECT_THROW(fitted_plane(std::vector<Vec3>{{2, 0, 0}, {2, 0, 0}, {2, 0, 0}}, "points"), InputError);
}

}  // namespace
}  // namespace talus
