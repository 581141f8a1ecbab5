#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "blocks.hpp"

namespace talus {
namespace {

using testing::box;
using testing::Scene;
using testing::Shape;
using testing::total_area;

constexpr double reach = 0.01;

/// A unit block of 3 × 3 cells at `offset` over a slab of 7 × 6 cells that do not match it.
Scene block_on_slab(const Vec3& offset, bool deformable_slab = false) {
  Scene scene;
  scene.add(box({0, 0, -1}, {5, 4, 0}, {7, 6, 1}), !deformable_slab);
  scene.add(box(offset, offset + Vec3(1, 1, 1), {3, 3, 3}, true));
  return scene;
}

void expect_upward(const ContactSet& contacts) {
  for (const ContactPoint& p : contacts.points) {
    // The slab comes first, so normals point from the block down to it.
    EXPECT_LT((p.normal - Vec3(0, 0, -1)).norm(), 1e-12) << p.normal.transpose() << " key " << std::hex << p.key;
  }
}

void expect_sound(const ContactSet& contacts) {
  std::set<std::uint64_t> keys;
  for (const ContactPoint& p : contacts.points) {
    EXPECT_TRUE(keys.insert(p.key).second) << "key twice";
    EXPECT_NEAR(p.normal.norm(), 1, 1e-12);
    EXPECT_TRUE(std::isfinite(p.gap) && p.position.allFinite() && std::isfinite(p.normal_stiffness));
    EXPECT_GT(p.normal_stiffness, 0);
    double plus = 0, minus = 0;
    for (int i = p.stencil_begin; i < p.stencil_end; ++i) {
      (contacts.weights[i] > 0 ? plus : minus) += contacts.weights[i];
    }
    EXPECT_NEAR(plus, 1, 1e-12);
    EXPECT_NEAR(minus, -1, 1e-12);
  }
}

TEST(Facing, AreaIsTheFacesAtEveryOffset) {
  for (double dx : {1.0, 1.1, 1 + 1.0 / 7, 10.0 / 7, 5.0 / 7 - 1e-9, 5.0 / 7 + 1e-13, 0.77, 2.2222}) {
    for (double dy : {1.0, 4.0 / 6, 1.2345, 2.0 - 1e-12, 8.0 / 6 - 1.0 / 3}) {
      Scene scene = block_on_slab({dx, dy, -1e-6});
      const ContactSet& contacts = scene.detect(reach);
      EXPECT_NEAR(total_area(contacts), 1, 1e-12) << dx << " " << dy;
      expect_upward(contacts);
      expect_sound(contacts);
      for (const ContactPoint& p : contacts.points) EXPECT_NEAR(p.gap, -1e-6, 1e-14);
    }
  }
}

}  // namespace
}  // namespace talus
