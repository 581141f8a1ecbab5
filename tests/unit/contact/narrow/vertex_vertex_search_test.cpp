#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.hpp"
#include "base/units.hpp"
#include "unit/contact/blocks.hpp"

/// Corners at corners and at sharp edges, and edges along edges: places without a normal of their own.
namespace talus {
namespace {

using testing::box;
using testing::mapped;
using testing::reach;
using testing::Scene;
using testing::Shape;

/// A spike with its tip at `tip` and its axis upwards, three times as long as the corner of a cube.
Shape spike(const Vec3& tip) {
  const Vec3 diagonal = Vec3(1, 1, 1).normalized();
  const Mat3 r = rotation_onto(diagonal, Vec3::UnitZ());
  return mapped(box({0, 0, 0}, {1, 1, 1}),
                [&](const Vec3& p) { return Vec3(r * (p + 2 * diagonal * diagonal.dot(p)) + tip); });
}

/// A roof with its top edge along y through the origin, from y = −1 to 1; its faces fall by 45°.
Shape roof() {
  const Mat3 r = Eigen::AngleAxisd(radians(-45), Vec3::UnitY()).toRotationMatrix();
  return mapped(box({-1, -1, -1}, {0, 1, 0}, {1, 3, 1}), [&](const Vec3& p) { return Vec3(r * p); });
}

TEST(VertexVertexSearch, ATipApartFromAConvexEdgeHasTheDirectionBetweenTheClosestPoints) {
  for (const double angle : {-30.0, 0.0, 20.0}) {
    const Vec3 up(std::sin(radians(angle)), 0, std::cos(radians(angle)));
    Scene scene;
    scene.add(roof(), true);
    scene.add(spike(0.008 * up + Vec3(0, 0.41, 0)));
    const ContactSet& contacts = scene.detect(reach);
    ASSERT_EQ(contacts.points.size(), 1u) << angle;
    EXPECT_LT((contacts.points[0].normal + up).norm(), 0.1) << contacts.points[0].normal.transpose();
    EXPECT_NEAR(contacts.points[0].gap, 0.008, 5e-5);
  }
}

/// Two surfaces as those of one body.
Shape joined(Shape a, const Shape& b) {
  const auto first = static_cast<int>(a.nodes.size());
  a.nodes.insert(a.nodes.end(), b.nodes.begin(), b.nodes.end());
  for (SurfaceTriangle triangle : b.triangles) {
    for (int& node : triangle.nodes) node += first;
    a.triangles.push_back(triangle);
  }
  return a;
}

TEST(VertexVertexSearch, TipsFarApartLeaveEdgesAloneThatTouchBesideThem) {
  const Shape lower =
      joined(roof(), mapped(spike({0.7, -0.5, 0.25}), [](const Vec3& p) { return Vec3(p.x(), -p.y(), -p.z()); }));
  const Mat3 across = (Mat3() << 0, 1, 0, 1, 0, 0, 0, 0, -1).finished();
  Scene scene;
  scene.add(lower, true);
  scene.add(mapped(lower, [&](const Vec3& p) { return Vec3(across * p - 1e-5 * Vec3::UnitZ()); }));
  bool tips = false, edges = false;
  for (const ContactPoint& p : scene.detect(0.6).points) {
    tips = tips || std::abs(p.gap - std::sqrt(0.33)) < 1e-4;
    edges = edges || std::abs(p.gap + 1e-5) < 1e-9;
  }
  EXPECT_TRUE(tips);
  EXPECT_TRUE(edges);
}

TEST(VertexVertexSearch, TheNormalTurnsWithTheTipAsItPassesOverTheEdge) {
  Vec3 former = Vec3(std::sqrt(0.5), 0, -std::sqrt(0.5));  // the left face's
  for (double x = -1e-3; x < 1e-3; x += 1e-5) {
    Scene scene;
    scene.add(roof(), true);
    scene.add(spike({x, 0.41, -std::abs(x) - 1e-7}));
    const ContactSet& contacts = scene.detect(reach);
    ASSERT_EQ(contacts.points.size(), 1u) << x;
    EXPECT_LT((contacts.points[0].normal - former).norm(), 0.12) << x;
    former = contacts.points[0].normal;
    if (std::abs(x) < 1e-8) {
      EXPECT_LT((former - Vec3(0, 0, -1)).norm(), 1e-3);
    }
  }
  EXPECT_LT((former - Vec3(-std::sqrt(0.5), 0, -std::sqrt(0.5))).norm(), 1e-9);
}

/// Adjacent faces of two acute edges overlap on both sides, with normals that push against each other.
TEST(VertexVertexSearch, AnAcuteEdgeThatHasSunkIntoAnotherIsHeldUpwards) {
  const Shape lower = mapped(roof(), [](const Vec3& p) { return Vec3(p.x(), p.y(), 6 * p.z()); });
  Scene scene;
  scene.add(lower, true);
  scene.add(mapped(lower, [&](const Vec3& p) { return Vec3(-0.9 * p.x(), 0.9 * p.y(), -0.9 * p.z() + 1e-3); }));
  double depth = -1e-3;
  for (const double displacement : {0.0, 1.1e-3, 2.9e-3, 7e-3}) {  // from outside, or a flush block would pass
    scene.move(1, {0, 0, -displacement});
    depth += displacement;
    const ContactSet& contacts = scene.detect(reach);
    ASSERT_FALSE(contacts.points.empty()) << depth;
    for (const ContactPoint& p : contacts.points) {
      EXPECT_LT((p.normal - Vec3(0, 0, -1)).norm(), 0.1) << depth << ": " << p.normal.transpose();
      EXPECT_NEAR(p.gap - p.initial_interference, -depth, 0.1 * std::abs(depth));
    }
    std::vector<ContactOutcome> outcomes;
    for (const ContactPoint& p : contacts.points)
      outcomes.push_back({.normal_force = 1, .gap = p.gap - p.initial_interference});
    scene.detector().accept(contacts, outcomes);
  }
}

/// The far faces of two acute edges that slide past each other overlap, too.
TEST(VertexVertexSearch, AnAcuteEdgeThatSlidesDownAFaceOfAnotherIsHeldByThisFace) {
  const Shape lower = mapped(roof(), [](const Vec3& p) { return Vec3(p.x(), p.y(), 6 * p.z()); });
  const Vec3 down = Vec3(1, 0, -6).normalized(), outwards = Vec3(6, 0, 1).normalized();
  Scene scene;
  scene.add(lower, true);
  scene.add(
      mapped(lower, [&](const Vec3& p) { return Vec3(p.cwiseProduct(Vec3(-0.9, 0.9, -0.9)) + 0.05 * outwards); }));
  double depth = -0.05;
  for (const auto& [along, into] : {std::pair(1e-3, 0.0499), {0.6e-3, 2e-4}, {0.6e-3, 1e-4}, {0.6e-3, 1e-4}}) {
    scene.move(1, along * down - into * outwards);
    depth += into;
    const ContactSet& contacts = scene.detect(reach);
    ASSERT_FALSE(contacts.points.empty()) << depth;
    std::vector<ContactOutcome> outcomes;
    for (const ContactPoint& p : contacts.points) {
      EXPECT_LT((p.normal + outwards).norm(), 0.1) << depth << ": " << p.normal.transpose();
      EXPECT_NEAR(p.gap - p.initial_interference, -depth, 1e-5);
      outcomes.push_back({.normal_force = 1, .gap = p.gap - p.initial_interference});
    }
    scene.detector().accept(contacts, outcomes);
  }
}

/// Two roofs, top edge on top edge, the upper one upside down, shifted along it and turned about the vertical.
void expect_held_at_both_ends(double shift, double turn, double gap) {
  SCOPED_TRACE(::testing::Message() << "shifted " << shift << ", turned " << turn << ", gap " << gap);
  Scene scene;
  scene.add(roof(), true);
  const Mat3 r = (Eigen::AngleAxisd(turn, Vec3::UnitZ()) * Eigen::AngleAxisd(radians(180), Vec3::UnitY())).matrix();
  scene.add(mapped(roof(), [&](const Vec3& p) { return Vec3(r * (0.9 * p) + Vec3(0, shift, gap)); }));
  const ContactSet& contacts = scene.detect(reach);
  ASSERT_EQ(contacts.points.size(), 2u);
  double first = INFINITY, last = -INFINITY;
  for (const ContactPoint& p : contacts.points) {
    EXPECT_LT((p.normal - Vec3(0, 0, -1)).norm(), 0.1) << p.normal.transpose();
    EXPECT_NEAR(p.gap, gap, 1e-5);
    first = std::min(first, p.position.y());
    last = std::max(last, p.position.y());
  }
  EXPECT_NEAR(first, std::max(-1.0, shift - 0.9), 1e-3);
  EXPECT_NEAR(last, std::min(1.0, shift + 0.9), 1e-3);
}

TEST(VertexVertexSearch, EdgesAlongEachOtherTouchAtTheEndsOfTheirCommonPart) {
  for (const double shift : {0.0, 0.1, 0.4}) {
    for (const double turn : {0.0, 1e-9, 1e-6, 1e-5}) expect_held_at_both_ends(shift, turn, 2e-3);
  }
}

TEST(VertexVertexSearch, EdgesThatCrossAtASmallAngleTouchWhereTheyCross) {
  for (const double degrees : {0.02, 0.1, 0.5, 1.0, 1.7, 1.9, 5.0}) {
    for (const double gap : {2e-3, 0.0, -1e-6, -1e-3}) {
      SCOPED_TRACE(::testing::Message() << "turned by " << degrees << "°, gap " << gap);
      Scene scene;
      scene.add(roof(), true);
      const Mat3 r =
          (Eigen::AngleAxisd(radians(degrees), Vec3::UnitZ()) * Eigen::AngleAxisd(radians(180), Vec3::UnitY()))
              .matrix();
      const Vec3 steeper(0.6, 0.9, 0.9);
      scene.add(mapped(roof(), [&](const Vec3& p) { return Vec3(r * p.cwiseProduct(steeper) + Vec3(0, 0.1, gap)); }));
      int in_the_middle = 0;
      for (const ContactPoint& p : scene.detect(reach).points) {
        if ((p.position - Vec3(0, 0.1, 0)).norm() > 0.05) continue;  // corners beside it, over the faces
        ++in_the_middle;
        EXPECT_LT((p.normal - Vec3(0, 0, -1)).norm(), 1e-6) << p.normal.transpose();
        EXPECT_NEAR(p.gap, gap, 1e-9);
      }
      EXPECT_EQ(in_the_middle, 1);
    }
  }
}

/// Two cubes whose upright edges touch, as two of the four blocks around a joint crossing do: one past the other's
/// corner in x and in y.
struct TwoCubes {
  Scene scene;
  TwoCubes() {
    scene.add(box({-1, -1, 0}, {0, 0, 1}), true);
    scene.add(box({0, 0, 0}, {1, 1, 1}));
  }
  std::size_t move_and_count(const Vec3& displacement) {
    scene.move(1, displacement);
    scene.detect(reach);
    const std::vector<ContactOutcome> outcomes(scene.contacts.points.size());
    scene.detector().accept(scene.contacts, outcomes);
    return scene.contacts.points.size();
  }
};

TEST(VertexVertexSearch, CornersOfBlocksThatLieFlushPass) {
  TwoCubes cubes;
  EXPECT_EQ(cubes.move_and_count({0, 0, 0}), 0u);
  for (int step = 0; step < 20; ++step) {
    cubes.move_and_count({-1e-5, 0, 0});
    for (const ContactPoint& p : cubes.scene.contacts.points) EXPECT_NEAR(p.normal.x(), 0, 1e-9) << step;
  }
  EXPECT_FALSE(cubes.scene.contacts.points.empty()) << "they lie flush, and touch by now";
}

TEST(VertexVertexSearch, CornersThatComeInFromOutsideOfAllFacesAreHeld) {
  TwoCubes cubes;
  EXPECT_EQ(cubes.move_and_count({0, 0, 0}), 0u);
  cubes.move_and_count({-1e-6, -1e-6, 0});
  ASSERT_EQ(cubes.scene.contacts.points.size(), 2u);  // at the top and at the bottom
  for (const ContactPoint& p : cubes.scene.contacts.points)
    EXPECT_LT((p.normal - Vec3(-1, -1, 0).normalized()).norm(), 1e-6) << p.normal.transpose();
}

}  // namespace
}  // namespace talus
