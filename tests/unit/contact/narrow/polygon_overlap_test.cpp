#include "contact/narrow/polygon_overlap.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace talus {
namespace {

OverlapPolygon polygon(const std::vector<Vec2>& corners) {
  OverlapPolygon p;
  for (const Vec2& corner : corners) p.corners.push_back(corner);
  distribute_area(p, {});
  return p;
}

Vec2 first_moment(const OverlapPolygon& p) {
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < p.corners.size(); ++i) sum += p.weights[i] * p.corners[i];
  return sum;
}

double weight_near(const OverlapPolygon& p, const Vec2& place, double distance) {
  double sum = 0;
  for (std::size_t i = 0; i < p.corners.size(); ++i)
    if ((p.corners[i] - place).norm() < distance) sum += p.weights[i];
  return sum;
}

TEST(PolygonOverlap, WeightsCarryLinearFunctionsExactly) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  int overlaps = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto triangle = [&] {
      std::array<Vec2, 3> t;
      for (Vec2& p : t) p = Vec2(any(random), any(random));
      if (cross(t[1] - t[0], t[2] - t[0]) < 0) std::swap(t[1], t[2]);
      return t;
    };
    OverlapPolygon p;
    overlap(triangle(), triangle(), {}, p);
    if (p.corners.empty()) continue;
    ++overlaps;
    // The same over a fan of triangles: the area, and the area times its centroid.
    double area = 0, sum = 0;
    Vec2 moment = Vec2::Zero();
    for (std::size_t k = 1; k + 1 < p.corners.size(); ++k) {
      const double part = cross(p.corners[k] - p.corners[0], p.corners[k + 1] - p.corners[0]) / 2;
      area += part;
      moment += part / 3 * (p.corners[0] + p.corners[k] + p.corners[k + 1]);
    }
    for (std::size_t k = 0; k < p.corners.size(); ++k) {
      EXPECT_GE(p.weights[k], 0);
      sum += p.weights[k];
    }
    EXPECT_NEAR(p.area, area, 1e-14);
    EXPECT_NEAR(sum, area, 1e-14);
    EXPECT_LT((first_moment(p) - moment).norm(), 1e-12);
  }
  EXPECT_GT(overlaps, 200);
}

TEST(PolygonOverlap, ACornerOnAStraightLineHasNoWeight) {
  const OverlapPolygon p = polygon({{0, 0}, {0.3, 0}, {1, 0}, {1, 1}, {0, 1}});
  EXPECT_NEAR(weight_near(p, {0.3, 0}, 1e-3), 0, 1e-15);
  for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})
    EXPECT_NEAR(weight_near(p, corner, 1e-3), 0.25, 1e-15);
}

TEST(PolygonOverlap, ASliverCutOffChangesWeightsByNoMoreThanItIsWide) {
  for (const double hair : {1e-3, 1e-6, 1e-8, 1e-10, 1e-13, 1e-16, 0.0}) {
    // Half of a square whose diagonal is broken in one place, and a square that lost a corner.
    const OverlapPolygon half = polygon({{0, 0}, {1, 0}, {1, 1}, {0.4 - hair, 0.4 + hair}});
    EXPECT_NEAR(weight_near(half, {0.4, 0.4}, 0.1), 0, 3 * hair + 1e-15) << hair;
    EXPECT_NEAR(weight_near(half, {1, 0}, 0.1), 1.0 / 6, 3 * hair + 1e-15) << hair;
    const OverlapPolygon cut = polygon({{hair, 0}, {1, 0}, {1, 1}, {0, 1}, {0, hair}});
    EXPECT_NEAR(weight_near(cut, {0, 0}, 0.1), 0.25, 3 * hair + 1e-7) << hair;
  }
}

TEST(PolygonOverlap, TwoSquaresShareARectangle) {
  const std::array<Vec2, 4> a = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
  const std::array<Vec2, 4> b = {Vec2(0.25, 0.5), Vec2(1.25, 0.5), Vec2(1.25, 1.5), Vec2(0.25, 1.5)};
  OverlapPolygon p;
  overlap(a, b, {}, p);
  EXPECT_EQ(p.corners.size(), 4U);
  EXPECT_NEAR(p.area, 0.75 * 0.5, 1e-15);
  for (const Vec2& corner : {Vec2(0.25, 0.5), Vec2(1, 0.5), Vec2(1, 1), Vec2(0.25, 1)})
    EXPECT_NEAR(weight_near(p, corner, 1e-9), 0.75 * 0.5 / 4, 1e-15) << corner.transpose();
}

}  // namespace
}  // namespace talus
