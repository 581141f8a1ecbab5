#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "base/rotation.hpp"
#include "base/units.hpp"
#include "unit/contact/blocks.hpp"

/// Blocks that slide where meshes, sizes and places could show: along grooves, off free edges, far away, small.
namespace talus {
namespace {

using testing::box;
using testing::mapped;
using testing::reach;
using testing::Scene;
using testing::Shape;
using testing::total_area;

/// A fixed slab whose upper face is z = |y|, from y = 0 to `width`, of either sign, along x from 0 to 5.
Shape groove_side(double width, std::array<int, 3> n) {
  Shape shape = mapped(box({0, 0, 0}, {5, 1, 1}, n), [&](const Vec3& p) {
    const double y = width * p.y();
    return Vec3(p.x(), y, p.z() * (std::abs(y) + 1) - 1);
  });
  if (width < 0) {
    for (SurfaceTriangle& t : shape.triangles) std::swap(t.nodes[0], t.nodes[1]);
  }
  return shape;
}

/// A cube in a groove of two planes with meshes of other sizes, everything scaled by s and moved far away.
Scene in_a_groove(double x, double s = 1, const Vec3& away = Vec3::Zero()) {
  const auto placed = [&](const Shape& shape) {
    return mapped(shape, [&](const Vec3& p) { return Vec3(s * p + away); });
  };
  const Mat3 turn = Eigen::AngleAxisd(radians(45), Vec3::UnitX()).toRotationMatrix();
  Scene scene;
  scene.add(placed(groove_side(2, {9, 4, 1})), true);
  scene.add(placed(groove_side(-2, {7, 3, 1})), true);
  const Shape cube = mapped(box({0, 0, 0}, {1, 1, 1}, {3, 3, 3}, true),
                            [&](const Vec3& p) { return Vec3(turn * p + Vec3(x, 0, -1e-6)); });
  scene.add(placed(cube));
  return scene;
}

struct Sides {
  double right = 0, left = 0;  // areas
  int others = 0;              // points with another normal or without an area
};

Sides sides_of(const ContactSet& contacts) {
  Sides sides;
  const double s = std::sqrt(0.5);
  for (const ContactPoint& p : contacts.points) {
    const Vec3 up = -p.normal;
    if (p.area > 0 && (up - Vec3(0, -s, s)).norm() < 1e-6)
      sides.right += p.area;
    else if (p.area > 0 && (up - Vec3(0, s, s)).norm() < 1e-6)
      sides.left += p.area;
    else
      ++sides.others;
  }
  return sides;
}

TEST(Sliding, AlongAGrooveOfMeshesThatDoNotMatch) {
  for (int step = 0; step < 120; ++step) {
    Scene scene = in_a_groove(0.3 + 0.0271 * step);
    const Sides sides = sides_of(scene.detect(reach));
    EXPECT_NEAR(sides.right, 1, 1e-5) << step;
    EXPECT_NEAR(sides.left, 1, 1e-5) << step;
    EXPECT_EQ(sides.others, 0) << step;
  }
}

TEST(Sliding, AGrooveFarFromTheOriginIsTheSameGroove) {
  for (double x : {0.3, 1.0, 1.7182, 3.1}) {
    Scene here = in_a_groove(x), far = in_a_groove(x, 1, Vec3(1e6, -1e6, 1e6));
    const Sides near_sides = sides_of(here.detect(reach)), far_sides = sides_of(far.detect(reach));
    EXPECT_NEAR(far_sides.right, near_sides.right, 1e-7);
    EXPECT_NEAR(far_sides.left, near_sides.left, 1e-7);
    EXPECT_EQ(far_sides.others, 0);
  }
}

TEST(Sliding, ATenthOfTheSizeGivesTheSameContactsScaled) {
  const double s = 0.1;
  for (double x : {0.3, 1.0, 1.7182, 3.1}) {
    Scene one = in_a_groove(x), tenth = in_a_groove(x, s);
    const ContactSet &a = one.detect(reach), &b = tenth.detect(s * reach);
    ASSERT_EQ(a.points.size(), b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i) {
      EXPECT_EQ(a.points[i].key, b.points[i].key);
      EXPECT_NEAR(a.points[i].gap * s, b.points[i].gap, 1e-14);
      EXPECT_NEAR(a.points[i].area * s * s, b.points[i].area, 1e-14);
      EXPECT_LT((a.points[i].normal - b.points[i].normal).norm(), 1e-12);
      EXPECT_NEAR(a.points[i].normal_stiffness * s, b.points[i].normal_stiffness, 1e-6 * b.points[i].normal_stiffness);
    }
  }
}

TEST(Sliding, MeshesThatCoincideAndThoseShiftedByAHairTouchAlike) {
  for (double shift : {0.0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3, 0.1, 1.0 / 6, 1.0 / 3}) {
    for (bool turned : {false, true}) {
      Scene scene;
      scene.add(box({-1, -1, -1}, {2, 2, 0}, {9, 9, 1}), true);  // the cube's cells are the slab's
      scene.add(box({shift, shift / 2, -1e-6}, {1 + shift, 1 + shift / 2, 1}, {3, 3, 3}, turned));
      const ContactSet& contacts = scene.detect(reach);
      EXPECT_NEAR(total_area(contacts), 1, 1e-12) << shift;
      double stiffness = 0;
      for (const ContactPoint& p : contacts.points) {
        stiffness += p.normal_stiffness;
        EXPECT_GT(p.area, 0) << shift << " a point beside those with an area";
        EXPECT_LT((p.normal - Vec3(0, 0, -1)).norm(), 1e-9);
      }
      EXPECT_NEAR(stiffness, 10 * 1e9 / scene.size(1), 1e-3) << shift;
    }
  }
}

TEST(Sliding, OffAFreeEdgeTheAreaGoesAndNoNormalTurns) {
  // The block slides over the sharp edge x = 5 of the slab until it hangs free, 1e-5 deep all the time.
  Scene scene;
  scene.add(box({0, 0, -1}, {5, 4, 0}, {7, 6, 2}), true);
  double x = 4.1;
  scene.add(box({x, 1.3, -1e-5}, {x + 1, 2.3, 1}, {3, 3, 3}, true));
  for (int step = 0; step < 100; ++step) {
    const ContactSet& contacts = scene.detect(reach);
    EXPECT_NEAR(total_area(contacts), std::max(0.0, 5 - x), 1e-2 * scene.size(1))
        << x;  // less a strip between two sharp edges
    std::vector<ContactOutcome> outcomes(contacts.points.size());
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      const ContactPoint& p = contacts.points[i];
      outcomes[i].gap = p.gap;
      scene.contacts.points[i].mode = p.gap > 0 ? ContactMode::open : ContactMode::slip;
      if (p.gap <= 0) {
        EXPECT_LT((p.normal - Vec3(0, 0, -1)).norm(), 1e-9) << x;
      }
    }
    scene.detector().accept(contacts, outcomes);
    scene.move(1, {0.0113, 0, 0});
    x += 0.0113;
  }
  EXPECT_TRUE(scene.detect(reach).points.empty());
}

TEST(Sliding, ACornerOffAFreeEdgeIsHeldUntilItIsPast) {
  const Mat3 turn = rotation_onto(Vec3(1, 1, 1), Vec3(0, 0, 1));
  Scene scene;
  scene.add(box({0, 0, -1}, {5, 4, 0}, {7, 6, 2}), true);
  double x = 4.9;
  scene.add(mapped(box({0, 0, 0}, {1, 1, 1}, {2, 2, 2}),
                   [&](const Vec3& p) { return Vec3(turn * p + Vec3(x, 1.7, -1e-5)); }));
  for (int step = 0; step < 150; ++step) {
    const ContactSet& contacts = scene.detect(1e-4);
    int up = 0;
    std::vector<ContactOutcome> outcomes(contacts.points.size());
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      const ContactPoint& p = contacts.points[i];
      outcomes[i].gap = p.gap;
      scene.contacts.points[i].mode = p.gap > 0 ? ContactMode::open : ContactMode::slip;
      if (p.gap > 0) continue;
      up += (p.normal - Vec3(0, 0, -1)).norm() < 1e-9;
      EXPECT_GT(-p.normal.z(), 0.5) << x;  // past the sharp edge an edge of the corner may rest on it
    }
    if (x < 4.999) {
      EXPECT_EQ(up, 1) << x;
    }
    if (x > 5.001) {
      EXPECT_EQ(up, 0) << x;
    }
    scene.detector().accept(contacts, outcomes);
    scene.move(1, {0.00113, 0, 0});
    x += 0.00113;
  }
}

}  // namespace
}  // namespace talus
