#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "unit/contact/blocks.hpp"

/// Features of two bodies in one place: corners, ends of edges and whole edges that coincide, exactly and but for a
/// hair. Some contact must have each of them, and only one.
namespace talus {
namespace {

using testing::box;
using testing::mapped;
using testing::on_a_corner;
using testing::Scene;
using testing::Shape;
using testing::total_area;

constexpr double short_reach = 1e-3;
constexpr double projection = 2e-6;  // m, on features of 1 m and diagonals: a millionth may be missed
const std::array<double, 9> hairs = {0, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 5e-5, 1e-4, 1e-3};
const std::array<Vec3, 2> places = {Vec3(0, 0, 0), Vec3(1e3, -1e3, 1e3)};

Shape placed(const Shape& shape, const Vec3& at) {
  return mapped(shape, [&](const Vec3& p) { return Vec3(p + at); });
}

/// A cube of 1 m that stands on one edge, along y, from `begin`.
Shape on_an_edge(const Vec3& begin, int n) {
  const Mat3 turn = Eigen::AngleAxisd(radians(-45), Vec3::UnitY()).toRotationMatrix();
  return mapped(box({0, 0, 0}, {1, 1, 1}, {n, n, n}), [&](const Vec3& p) { return Vec3(turn * p + begin); });
}

/// No two contacts that push lie in one place.
void expect_each_once(const ContactSet& contacts, double apart) {
  for (std::size_t i = 0; i < contacts.points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (contacts.points[i].gap >= 0 || contacts.points[j].gap >= 0) continue;
      EXPECT_GT((contacts.points[i].position - contacts.points[j].position).norm(), apart)
          << contacts.points[i].position.transpose() << " with " << contacts.points[i].normal.transpose() << " and "
          << contacts.points[j].normal.transpose();
    }
  }
}

/// Contacts that carry upwards alone, with one gap, at both ends of a length along y.
void expect_held_along(const ContactSet& contacts, double begin, double end, double gap) {
  ASSERT_GE(contacts.points.size(), 2u);
  double first = INFINITY, last = -INFINITY;
  for (const ContactPoint& p : contacts.points) {
    EXPECT_LT((p.normal - Vec3(0, 0, -1)).norm(), 1e-9) << p.normal.transpose();
    EXPECT_NEAR(p.gap, gap, 1e-11);
    first = std::min(first, p.position.y());
    last = std::max(last, p.position.y());
  }
  EXPECT_NEAR(first, begin, projection);
  EXPECT_NEAR(last, end, projection);
  expect_each_once(contacts, 1e-2);
}

TEST(Coincidence, AnEdgeRestsOnAFaceAsWideAsItIsLong) {
  for (const Vec3& at : places) {
    for (const double hair : hairs) {
      for (const double sign : {-1, 1}) {
        for (const double gap : {-2e-3, -1e-5, 0.0, 1e-5}) {
          for (const int n : {1, 3}) {
            SCOPED_TRACE(::testing::Message() << "shifted by " << sign * hair << ", gap " << gap << ", cells " << n);
            Scene scene;
            scene.add(placed(box({-2, 0, -1}, {2, 1, 0}, {2, n, 1}), at), true);
            scene.add(placed(on_an_edge({0.3, sign * hair, gap}, n), at));
            const double begin = std::max(0.0, sign * hair), end = std::min(1.0, 1 + sign * hair);
            expect_held_along(scene.detect(short_reach), at.y() + begin, at.y() + end, gap);
          }
        }
      }
    }
  }
}

TEST(Coincidence, AnEdgeALittleLongerOrShorterThanTheFaceIsWideRestsOnItToo) {
  for (const double hair : hairs) {
    for (const double sign : {-1, 1}) {
      SCOPED_TRACE(::testing::Message() << "longer by " << 2 * sign * hair);
      Scene scene;
      scene.add(box({-2, 0, -1}, {2, 1, 0}), true);
      scene.add(mapped(on_an_edge({0.3, 0, -1e-5}, 1),
                       [&](const Vec3& p) { return Vec3(p.x(), 0.5 + (p.y() - 0.5) * (1 + 2 * sign * hair), p.z()); }));
      const double overhang = std::min(0.0, sign * hair);
      expect_held_along(scene.detect(short_reach), -overhang, 1 + overhang, -1e-5);
    }
  }
}

TEST(Coincidence, AnEdgeIsHeldUpToTheSharpEdgeItRunsAlong) {
  for (const Vec3& at : places) {
    for (const double hair : hairs) {
      for (const double sign : {-1, 1}) {
        SCOPED_TRACE(::testing::Message() << "over the sharp edge by " << sign * hair);
        Scene scene;
        scene.add(placed(box({-2, 0, -1}, {0, 1, 0}), at), true);
        scene.add(placed(on_an_edge({sign * hair, 0, -1e-5}, 1), at));
        const ContactSet& contacts = scene.detect(short_reach);
        double first = INFINITY, last = -INFINITY;
        for (const ContactPoint& p : contacts.points) {
          EXPECT_GT(-p.normal.z(), 0.7) << p.normal.transpose();
          first = std::min(first, p.position.y() - at.y());
          last = std::max(last, p.position.y() - at.y());
        }
        EXPECT_NEAR(first, 0, projection);
        EXPECT_NEAR(last, 1, projection);
        expect_each_once(contacts, 1e-2);
      }
    }
  }
}

TEST(Coincidence, EqualBoxesStackedCornerOnCornerTouchOverTheirWholeFace) {
  for (const Vec3& at : places) {
    for (const double hair : hairs) {
      for (const double across : {0.0, 0.5, 1.0, -1.0}) {
        for (const int n : {1, 2}) {
          SCOPED_TRACE(::testing::Message() << "shifted by " << hair << " and " << across * hair << ", cells " << n);
          Scene scene;
          scene.add(placed(box({0, 0, -1}, {1, 1, 0}), at), true);
          scene.add(placed(box({hair, across * hair, -1e-6}, {1 + hair, 1 + across * hair, 1}, {n, n, n}), at));
          const ContactSet& contacts = scene.detect(short_reach);
          EXPECT_NEAR(total_area(contacts), (1 - hair) * (1 - std::abs(across) * hair), 1e-9);
          for (const ContactPoint& p : contacts.points) {
            EXPECT_GT(p.area, 0) << "a point beside those with an area";
            EXPECT_LT((p.normal - Vec3(0, 0, -1)).norm(), 1e-9) << p.normal.transpose();
          }
        }
      }
    }
  }
}

TEST(Coincidence, ATipIsHeldOverASharpEdgeUntilItsEdgesHaveLeftIt) {
  for (const Vec3& at : places) {
    for (const double depth : {1e-5, 2e-3}) {
      for (const double hair : hairs) {
        for (const double sign : {-1, 1}) {
          SCOPED_TRACE(::testing::Message() << "over the sharp edge by " << sign * hair << ", deep " << depth);
          Scene scene;
          scene.add(placed(box({-2, 0, -1}, {0, 1, 0}), at), true);
          scene.add(placed(on_a_corner({sign * hair, 0.4, -depth}, 1), at));
          double deepest = 0;
          for (const ContactPoint& p : scene.detect(short_reach).points) {
            EXPECT_GT(-p.normal.z(), 0.5) << p.normal.transpose();
            deepest = std::max(deepest, -p.gap);
          }
          if (sign * hair < depth / 2) {  // its edges rise by 35°
            EXPECT_GT(deepest, depth / 4);
          }
        }
      }
    }
  }
}

TEST(Coincidence, FlushBlocksPassEachOther) {
  // The cube's side lies in the plane of the wall's, which ends where the cube goes; both are as high as each other.
  for (const double hair : hairs) {
    if (hair > 5e-5) continue;  // wider than the strip by which two sharp edges may pass
    for (const double sign : {-1, 1}) {
      for (const double x : {-5e-4, -1e-6, 0.0, 1e-6, 1e-5, 0.3, 1.0, 1.7}) {
        SCOPED_TRACE(::testing::Message() << "nearer by " << sign * hair << ", at " << x);
        Scene scene;
        scene.add(box({0, -1, 0}, {1, 0, 1}), true);
        scene.add(box({x - 1, -sign * hair, 0}, {x, 1 - sign * hair, 1}));
        EXPECT_EQ(scene.detect(short_reach).points.empty(), x < 0.1) << "beside each other they touch";
        for (const ContactPoint& p : scene.contacts.points) {
          EXPECT_NEAR(p.normal.x(), 0, 1e-9) << p.normal.transpose() << " at " << p.position.transpose();
          EXPECT_NEAR(p.normal.z(), 0, 1e-9) << p.normal.transpose() << " at " << p.position.transpose();
        }
      }
    }
  }
}

}  // namespace
}  // namespace talus
