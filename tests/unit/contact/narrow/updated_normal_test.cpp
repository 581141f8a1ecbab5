#include <gtest/gtest.h>

#include <cmath>

#include "base/units.hpp"
#include "unit/contact/blocks.hpp"

/// Normals told beforehand of contacts that rotate while they slide.
namespace talus {
namespace {

using testing::box;
using testing::mapped;
using testing::Scene;

constexpr double wide_reach = 0.05;

/// The block moves, turning about its centroid; the first body stands. What was told of each point must be what is
/// found at the end, where it is found by the same key.
void expect_told_beforehand(Scene& scene, const Vec3& axis, double degrees, const Vec3& displacement, double within) {
  const ContactSet before = scene.detect(wide_reach);
  const std::vector<Vec3> start = scene.x;
  std::vector<Vec3> end = start;
  Vec3 centre = Vec3::Zero();
  for (int i = 0; i < scene.node_count(1); ++i) centre += start[scene.first_node(1) + i] / scene.node_count(1);
  const Mat3 r = Eigen::AngleAxisd(radians(degrees), axis.normalized()).toRotationMatrix();
  for (int i = 0; i < scene.node_count(1); ++i) {
    Vec3& p = end[scene.first_node(1) + i];
    p = r * (p - centre) + centre + displacement;
  }
  std::vector<ContactDetector::UpdatedNormal> told;
  for (int i = 0; i < static_cast<int>(before.points.size()); ++i)
    told.push_back(scene.detector().updated_normal(i, start, end));
  scene.x = end;
  int compared = 0;
  for (const ContactPoint& after : scene.detect(wide_reach).points)
    for (std::size_t i = 0; i < told.size(); ++i) {
      const ContactPoint& p = before.points[i];
      if (p.key != after.key) continue;
      EXPECT_LT((told[i].normal - after.normal).norm(), within) << std::hex << p.key;
      EXPECT_NEAR(told[i].gap, after.gap, within) << std::hex << p.key;
      ++compared;
    }
  EXPECT_GT(compared, 0);
}

TEST(UpdatedNormals, AVertexOnAFacetThatRotates) {
  Scene scene;
  const Mat3 r = Eigen::AngleAxisd(radians(40), Vec3(1, 0.7, 0).normalized()).toRotationMatrix();
  scene.add(mapped(box({0, 0, -1}, {1, 1, 0}), [&](const Vec3& p) { return Vec3(r * (p - Vec3(0, 1, 0))); }), true);
  scene.add(box({-2, -2, 0.001}, {2, 2, 1}));
  expect_told_beforehand(scene, {1, 0.3, 0}, 0.5, {0.02, -0.01, 0}, 1e-12);
}

TEST(UpdatedNormals, EdgesAcrossEachOther) {
  Scene scene;
  const Mat3 roof = Eigen::AngleAxisd(radians(45), Vec3::UnitY()).toRotationMatrix();
  const Mat3 across = Eigen::AngleAxisd(radians(70), Vec3::UnitZ()).toRotationMatrix();
  const Vec3 top_edge(std::sqrt(0.5), 0, 0);
  const auto long_box = [&] { return box({-0.5, -2, -0.5}, {0.5, 2, 0.5}); };
  scene.add(mapped(long_box(), [&](const Vec3& p) { return Vec3(roof * p); }), true);
  scene.add(mapped(long_box(), [&](const Vec3& p) {
    return Vec3(across * (roof * p) + Vec3(0.01, 0.02, 2 * top_edge.x() + 0.001));
  }));
  expect_told_beforehand(scene, {0.2, 1, 0.4}, 0.5, {0.02, -0.01, 0}, 1e-12);
}

/// A block that leans by `degrees` on a plane whose mesh is finer than it.
Scene leaning(double degrees) {
  Scene scene;
  scene.add(box({-3, -3, -1}, {3, 3, 0}, {9, 9, 1}), true);
  const Mat3 r = Eigen::AngleAxisd(radians(degrees), Vec3(1, 0.3, 0).normalized()).toRotationMatrix();
  scene.add(mapped(box({-0.5, -0.4, 0}, {0.5, 0.6, 1}), [&](const Vec3& p) { return Vec3(r * p); }));
  return scene;
}

TEST(UpdatedNormals, VerticesAndEdgesOfABlockHaveTheNormalOfThePlaneTheyLieIn) {
  for (const double degrees : {1.0, 1e-6}) {
    Scene scene = leaning(degrees);
    const ContactSet& contacts = scene.detect(wide_reach);
    const Scene further = leaning(degrees + 0.5);
    int vertices = 0, crossings = 0;
    for (int i = 0; i < static_cast<int>(contacts.points.size()); ++i) {
      const ContactPoint& p = contacts.points[i];
      const Vec3 from_rim = (p.position - Vec3(0, 0.1, p.position.z())).cwiseAbs();
      const bool on_rim = std::abs(from_rim.head<2>().maxCoeff() - 0.5) < 1e-3;
      const bool is_crossing = p.key >> 62 == 2;
      if (!on_rim || (!is_crossing && p.key >> 62 != 1)) continue;
      EXPECT_EQ(p.normal, -Vec3::UnitZ()) << degrees << "°, " << p.position.transpose();
      EXPECT_LT((scene.detector().updated_normal(i, scene.x, further.x).normal + Vec3::UnitZ()).norm(), 1e-12)
          << "once the block has rotated further";
      EXPECT_GT(p.area, 0);
      (is_crossing ? crossings : vertices) += 1;
    }
    EXPECT_EQ(vertices, 4);
    EXPECT_GT(crossings, 8);
  }
}

}  // namespace
}  // namespace talus
