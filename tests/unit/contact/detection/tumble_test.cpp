#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "unit/contact/blocks.hpp"

namespace talus {
namespace {

using testing::box;
using testing::mapped;
using testing::Scene;

/// A cube thrown at every attitude into the corner region of a slab: whatever is found must be a sound contact, that
/// is, a direction that separates: moving the cube along it by the gap's depth opens the contact.
TEST(Tumble, EveryAttitudeGivesSoundContacts) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0, 1);
  const double reach = 0.02;
  int found = 0;
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Quaterniond q =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
    const Mat3 r = q.toRotationMatrix();
    const auto cube =
        mapped(box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, {2, 2, 2}, i % 2), [&](const Vec3& p) { return Vec3(r * p); });
    double lowest = 0;
    for (const Vec3& p : cube.nodes) lowest = std::min(lowest, p.z());
    // Over the slab's middle, its edge or its corner; 0.01 deep to 0.01 above.
    const Vec3 at(3 + unit(random) * 2.2, 2 + unit(random) * 2.2, -lowest + 0.02 * unit(random) - 0.01);
    Scene scene;
    scene.add(box({0, 0, -1}, {5, 4, 0}, {7, 6, 1}), true);
    scene.add(mapped(cube, [&](const Vec3& p) { return Vec3(p + at); }));
    const ContactSet& contacts = scene.detect(reach);
    found += !contacts.points.empty();
    bool deep_upward = false;
    for (const ContactPoint& p : contacts.points) {
      ASSERT_TRUE(p.normal.allFinite() && std::isfinite(p.gap) && p.position.allFinite()) << i;
      EXPECT_NEAR(p.normal.norm(), 1, 1e-12);
      EXPECT_LE(p.gap, reach);
      EXPECT_GE(p.gap, -0.3 * p.size);
      EXPECT_LT(p.normal.z(), 0.2) << i << " would push the cube into the slab: " << p.normal.transpose();
      deep_upward = deep_upward || p.normal.z() < -0.99;
    }
    const bool over_the_middle = at.x() < 4 && at.y() < 3;  // half the cube's diagonal away from the edge
    if (over_the_middle) {
      EXPECT_TRUE(deep_upward) << i << ": the lowest corner is lost";
    }
  }
  EXPECT_GT(found, 2000);
}

}  // namespace
}  // namespace talus
