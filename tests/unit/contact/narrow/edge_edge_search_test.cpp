#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "unit/contact/blocks.hpp"

namespace talus {
namespace {

using testing::box;
using testing::cells;
using testing::mapped;
using testing::reach;
using testing::Scene;
using testing::Shape;

/// A long box with one edge through `place` along `direction`, that opens towards `towards`.
Shape edge_through(const Vec3& place, const Vec3& direction, const Vec3& towards) {
  const Vec3 along = direction.normalized(), middle = (towards - along * along.dot(towards)).normalized(),
             aside = along.cross(middle), u = (middle - aside).normalized(), v = (middle + aside).normalized();
  return mapped(box({-0.5, 0, 0}, {0.5, 1, 1}),
                [=](const Vec3& p) { return Vec3(place + p.x() * along + p.y() * u + p.z() * v); });
}

/// Two edges meet in the corner at the end of a notch; what sinks into the corner is past the ends of both.
TEST(EdgeEdgeSearch, BothEdgesAtTheEndOfANotchHoldAnEdgeThatSinksIntoItsCorner) {
  const Shape notched = cells({2, 1, 2}, [](int i, int, int k) { return i == 0 || k == 0; });
  const Vec3 corner(1, 0, 1), into_the_notch(0.3, 0.84, 0.45), free(1, 0, 1);
  for (const double depth : {1e-6, 1e-4, 1e-3}) {
    for (const double aside : {0.0, 0.2, -0.2}) {
      Scene scene;
      scene.add(notched, true);
      const Vec3 place = corner - depth * (free + aside * Vec3(1, 0, -1)).normalized();
      scene.add(edge_through(place, into_the_notch, free));
      const ContactSet& contacts = scene.detect(reach);
      const auto held_against = [&](const Vec3& side) {
        return std::ranges::any_of(contacts.points,
                                   [&](const ContactPoint& p) { return p.gap < 0 && p.normal.dot(side) > 0.8; });
      };
      EXPECT_TRUE(held_against(-Vec3::UnitX())) << depth << " " << aside;
      EXPECT_TRUE(held_against(-Vec3::UnitZ())) << depth << " " << aside;
      for (const ContactPoint& p : contacts.points)
        for (int k = p.stencil_begin; k < p.stencil_end; ++k) EXPECT_LE(std::abs(contacts.weights[k]), 1);
    }
  }
}

/// Ridges that cross at a hundredth of a radian have a direction across both, that of their contact.
TEST(EdgeEdgeSearch, RidgesThatHardlyCrossTouchAcrossBoth) {
  const Shape ridge = edge_through({0, 0, 0}, Vec3::UnitY(), -Vec3::UnitZ());
  const Vec3 direction(0.01, 1, 0.005);
  Scene scene;
  scene.add(ridge, true);
  scene.add(edge_through({0, 0, -1e-4}, direction, {-0.4, 0, 1}));
  const Vec3 across = Vec3::UnitY().cross(direction).normalized();
  const ContactSet& contacts = scene.detect(1e-5);
  ASSERT_EQ(contacts.points.size(), 1u);
  EXPECT_LT((contacts.points[0].normal - across).norm(), 1e-9) << contacts.points[0].normal.transpose();
  EXPECT_NEAR(contacts.points[0].gap, 1e-4 * across.z(), 1e-12);
}

}  // namespace
}  // namespace talus
