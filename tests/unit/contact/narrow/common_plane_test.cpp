#include "contact/narrow/common_plane.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

namespace talus {
namespace {

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  return a + ab * std::clamp(ab.dot(p - a) / ab.squaredNorm(), 0.0, 1.0);
}

double point_to_triangle(const Vec3& p, const Triangle& t) {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) least = std::min(least, (p - nearest_on_segment(p, t[k], t[(k + 1) % 3])).norm());
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  bool inside = true;
  for (int k = 0; k < 3; ++k) inside = inside && n.cross(t[(k + 1) % 3] - t[k]).dot(p - t[k]) >= 0;
  return inside ? std::min(least, std::abs(n.dot(p - t[0]))) : least;
}

double segment_to_segment(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  double least = std::min({(a - nearest_on_segment(a, c, d)).norm(), (b - nearest_on_segment(b, c, d)).norm(),
                           (c - nearest_on_segment(c, a, b)).norm(), (d - nearest_on_segment(d, a, b)).norm()});
  const Vec3 u = b - a, w = d - c, n = u.cross(w), r = c - a;
  const double s = r.cross(w).dot(n) / n.squaredNorm(), t = r.cross(u).dot(n) / n.squaredNorm();
  if (s >= 0 && s <= 1 && t >= 0 && t <= 1) least = std::min(least, std::abs(n.dot(r)) / n.norm());
  return least;
}

bool pierces(const Vec3& a, const Vec3& b, const Triangle& t) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  const double da = n.dot(a - t[0]), db = n.dot(b - t[0]);
  if (da * db > 0) return false;
  const Vec3 p = a + (b - a) * (da / (da - db));
  for (int k = 0; k < 3; ++k) {
    if (n.cross(t[(k + 1) % 3] - t[k]).dot(p - t[k]) < 0) return false;
  }
  return true;
}

/// Distance of two triangles by trying everything; 0 where they cross.
double distance(const Triangle& a, const Triangle& b) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    least = std::min({least, point_to_triangle(a[i], b), point_to_triangle(b[i], a)});
    if (pierces(a[i], a[(i + 1) % 3], b) || pierces(b[i], b[(i + 1) % 3], a)) return 0;
    for (int j = 0; j < 3; ++j) least = std::min(least, segment_to_segment(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
  }
  return least;
}

void expect_plane(const CommonPlane& p, double gap, const Vec3& normal) {
  EXPECT_NEAR(p.gap, gap, 1e-12);
  EXPECT_LT((p.normal - normal).norm(), 1e-12) << p.normal.transpose();
}

CommonPlane plane_between(const Triangle& a, const Triangle& b, const Vec3& outward = Vec3::Zero()) {
  return common_plane(a, b, outward, {});
}

const Triangle ground = {Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 3, 0)};

TEST(CommonPlane, VertexOverFace) {
  const Triangle a = {Vec3(1, 1, 0.25), Vec3(0.9, 1, 2), Vec3(1, 1.4, 2)};
  const CommonPlane p = plane_between(a, ground);
  expect_plane(p, 0.25, {0, 0, 1});
  expect_plane(plane_between(ground, a), 0.25, {0, 0, -1});
}

TEST(CommonPlane, EdgesCrossing) {
  const Triangle a = {Vec3(-1, 0, 0.1), Vec3(1, 0, 0.1), Vec3(0, 0, 2)};
  const Triangle b = {Vec3(0, -1, 0), Vec3(0, 1, 0), Vec3(0, 0, -2)};
  expect_plane(plane_between(a, b), 0.1, {0, 0, 1});
}

TEST(CommonPlane, FaceOverFace) {
  const Triangle a = {Vec3(1, 1, 0.5), Vec3(1, 2, 0.5), Vec3(2, 1, 0.5)};
  expect_plane(plane_between(a, ground), 0.5, {0, 0, 1});
}

TEST(CommonPlane, VerticesApart) {
  const Triangle a = {Vec3(-1, -1, 1), Vec3(-2, -1, 2), Vec3(-1, -2, 2)};
  expect_plane(plane_between(a, ground), std::sqrt(3.0), Vec3(-1, -1, 1).normalized());
}

TEST(CommonPlane, VertexBesideEdge) {
  const Triangle a = {Vec3(1.5, -0.3, 0.4), Vec3(1.5, -3, 4), Vec3(1.6, -4, 4)};
  expect_plane(plane_between(a, ground), 0.5, Vec3(0, -0.6, 0.8));
}

TEST(CommonPlane, CrossingFacetsHaveTheLeastPenetration) {
  // A spike through the ground by 0.01: every direction is deeper than straight up.
  const Triangle a = {Vec3(1, 1, -0.01), Vec3(0.9, 1, 2), Vec3(1.1, 1.2, 2)};
  expect_plane(plane_between(a, ground), -0.01, {0, 0, 1});
}

TEST(CommonPlane, FacetsInEachOtherFaceToFaceAreNotApartOnTheirWrongSides) {
  const Triangle lower = {Vec3(0.5, 0.5, -0.01), Vec3(0.5, 1.5, -0.01), Vec3(1.5, 0.5, -0.01)};  // looks down
  expect_plane(plane_between(lower, ground), 0.01, {0, 0, -1});
  expect_plane(plane_between(lower, ground, {0, 0, 2}), -0.01, {0, 0, 1});
}

TEST(CommonPlane, CrossingFacetsAreNotPartedSideways) {
  // It reaches over the side y = 0 by 0.001, and is 0.01 deep: sideways is nearer, but that side is the mesh's.
  const Triangle a = {Vec3(1, 0.001, -0.01), Vec3(0.5, -1, -0.01), Vec3(1.5, -1, -0.01)};
  expect_plane(plane_between(a, ground, {0, 0, 2}), -0.01, {0, 0, 1});
}

TEST(CommonPlane, GapIsTheDistanceOfRandomTriangles) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto point = [&](double scale) { return Vec3(scale * Vec3(unit(random), unit(random), unit(random))); };
  int apart = 0, missed = 0, iterations = 0;
  for (int i = 0; i < 20000; ++i) {
    Triangle a, b;
    const Vec3 shift = point(2);
    for (int k = 0; k < 3; ++k) a[k] = point(1), b[k] = shift + point(1);
    const double true_distance = distance(a, b);
    const CommonPlane p = plane_between(a, b);
    EXPECT_LE(p.gap, true_distance + 1e-12);  // never called apart when near
    EXPECT_TRUE(p.converged);
    if (true_distance == 0) continue;
    ++apart;
    iterations += p.iterations;
    if (p.gap < true_distance * (1 - 1e-9) - 1e-12) ++missed;
  }
  EXPECT_EQ(missed, 0);
  EXPECT_LT(static_cast<double>(iterations) / apart, 3.0);
}

}  // namespace
}  // namespace talus
