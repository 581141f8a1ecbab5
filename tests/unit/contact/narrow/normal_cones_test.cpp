#include <gtest/gtest.h>

#include <cmath>

#include "base/units.hpp"
#include "unit/contact/blocks.hpp"

/// Edges that touch though the corner they end in cannot.
namespace talus {
namespace {

using testing::cells;
using testing::mapped;
using testing::Scene;
using testing::Shape;

constexpr double half_width = 0.25, height = 3;  // m, of the hole; of the pyramid, whose base is 1 m wide

/// A square hole in a plate whose top is at z = 0, with its axis along z.
Shape plate_with_hole() {
  return mapped(cells({3, 3, 2}, [](int i, int j, int k) { return i != 1 || j != 1 || k == 0; }), [](const Vec3& p) {
    const auto line = [](double cell) { return std::array{-1.0, -half_width, half_width, 1.0}[std::lround(cell)]; };
    return Vec3(line(p.x()), line(p.y()), 2 * p.z() - 4);
  });
}

/// Tip down.
Shape pyramid(double tip) {
  return {{{-0.5, -0.5, tip + height},
           {0.5, -0.5, tip + height},
           {0.5, 0.5, tip + height},
           {-0.5, 0.5, tip + height},
           {0, 0, tip}},
          {{{0, 1, 2}, -1}, {{0, 2, 3}, -1}, {{1, 0, 4}, -1}, {{2, 1, 4}, -1}, {{3, 2, 4}, -1}, {{0, 3, 4}, -1}}};
}

TEST(NormalCones, APyramidInASquareHoleTouchesAllFourEdges) {
  const double rise = 0.5 / height, slant = std::hypot(1.0, rise);  // of a face, outwards
  for (const double depth : {1e-6, 1e-4, 1e-2}) {
    SCOPED_TRACE(::testing::Message() << depth << " m deep");
    Scene scene;
    scene.add(plate_with_hole(), true);
    scene.add(pyramid(-height / 2 - depth));
    const ContactSet& contacts = scene.detect(0.01);
    EXPECT_EQ(contacts.points.size(), 8u);
    for (const Vec3& out : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
      const Vec3 normal = (out - rise * Vec3::UnitZ()) / slant;  // of the pyramid's face
      int at_both_ends = 0;
      for (const ContactPoint& p : contacts.points) {
        if ((p.normal - normal).norm() > 1e-9) continue;
        ++at_both_ends;
        EXPECT_NEAR(p.gap, -depth * rise / slant, 1e-12);
        EXPECT_NEAR(p.position.cwiseAbs().x(), half_width, 1e-9);
        EXPECT_NEAR(p.position.cwiseAbs().y(), half_width, 1e-9);
      }
      EXPECT_EQ(at_both_ends, 2) << out.transpose();
    }
  }
}

TEST(NormalCones, AConcaveEdgeDoesNotTouch) {
  // Three arms meet in a corner, and a block fills the groove between two of them. Its end face is just past the
  // corner, whose edges run along that face or away from it; but they are concave.
  const Mat3 turn = Eigen::AngleAxisd(radians(0.5), Vec3(0, 1, 1).normalized()).toRotationMatrix();
  Scene scene;
  scene.add(mapped(cells({2, 2, 2}, [](int i, int j, int k) { return i + j + k <= 1; }),
                   [&](const Vec3& p) { return Vec3(turn * (p - Vec3::Ones())); }),
            true);
  scene.add(testing::box({-0.9, 0, 0}, {0.01, 0.8, 0.8}));
  const ContactSet& contacts = scene.detect(0.02);
  EXPECT_FALSE(contacts.points.empty());
  for (const ContactPoint& p : contacts.points) EXPECT_LT(std::abs(p.normal.x()), 0.5) << p.normal.transpose();
}

}  // namespace
}  // namespace talus
