#include "render/stereonet/contour_bands.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace talus {
namespace {

/// 1 − r² at the nodes.
std::vector<double> hill(int size) {
  std::vector<double> values;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      values.push_back(1 - Vec2(2.0 * column / (size - 1) - 1, 2.0 * row / (size - 1) - 1).squaredNorm());
  return values;
}

double area_of(const std::vector<NetPolygon>& region) {
  double area = 0;
  for (const NetPolygon& polygon : region)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      area += (a.x() * b.y() - a.y() * b.x()) / 2;
    }
  return area;
}

TEST(ContourBands, OfAHillAreDiscs) {
  for (const double level : {0.2, 0.5, 0.75})
    EXPECT_NEAR(area_of(region_above(hill(201), 201, level)), std::numbers::pi * (1 - level), 1e-3) << level;
}

TEST(ContourBands, OfAHillHaveCirclesForBorders) {
  double length = 0;
  for (const NetPolygon& line : contour_lines(hill(201), 201, 0.75)) {
    length += (line[1] - line[0]).norm();
    EXPECT_NEAR(line[0].norm(), 0.5, 1e-4);
  }
  EXPECT_NEAR(length, std::numbers::pi, 1e-3);
}

TEST(ContourBands, OfAPlainAreAllOrNothing) {
  const std::vector<double> flat(25, 1.0);
  EXPECT_NEAR(area_of(region_above(flat, 5, 0.5)), 4, 1e-12);
  EXPECT_TRUE(region_above(flat, 5, 1.5).empty());
  EXPECT_TRUE(contour_lines(flat, 5, 0.5).empty());
}

}  // namespace
}  // namespace talus
