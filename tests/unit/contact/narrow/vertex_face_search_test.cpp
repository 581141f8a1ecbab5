#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/rotation.hpp"
#include "base/units.hpp"
#include "unit/contact/blocks.hpp"

namespace talus {
namespace {

using testing::box;
using testing::cells;
using testing::mapped;
using testing::on_a_corner;
using testing::reach;
using testing::Scene;
using testing::Shape;
using testing::total_area;

Shape turned(const Shape& shape, double degrees, const Vec3& axis, const Vec3& to) {
  const Mat3 r = Eigen::AngleAxisd(radians(degrees), axis.normalized()).toRotationMatrix();
  return mapped(shape, [&](const Vec3& p) { return Vec3(r * p + to); });
}

/// A cube that stands on one edge, along y, from `begin`.
Shape on_an_edge(const Vec3& begin, std::array<int, 3> n = {2, 2, 2}) {
  return turned(box({0, 0, 0}, {1, 1, 1}, n), -45, Vec3::UnitY(), begin);
}

void expect_one(const ContactSet& contacts, const Vec3& normal, double gap, const Vec3& position) {
  ASSERT_EQ(contacts.points.size(), 1u);
  const ContactPoint& p = contacts.points[0];
  EXPECT_LT((p.normal - normal).norm(), 1e-9) << p.normal.transpose();
  EXPECT_NEAR(p.gap, gap, 1e-9);
  EXPECT_LT((p.position - position).norm(), 1e-2) << p.position.transpose();
  EXPECT_EQ(p.area, 0);
  EXPECT_GT(p.normal_stiffness, 0);
}

/// A wedge that lies on the plane z = 0, its acute edge along y through the origin, and rises by a tenth.
Shape acute_wedge() {
  return {{{0, 0, 0}, {0, 4, 0}, {1, 0, 0}, {1, 4, 0}, {1, 0, 0.1}, {1, 4, 0.1}},
          {{{0, 1, 3}, -1},
           {{0, 3, 2}, -1},
           {{0, 4, 5}, -1},
           {{0, 5, 1}, -1},
           {{2, 3, 5}, -1},
           {{2, 5, 4}, -1},
           {{0, 2, 4}, -1},
           {{1, 5, 3}, -1}}};
}

TEST(VertexFaceSearch, ATipBelowAnAcuteEdgeIsNotBehindTheFaceAboveIt) {
  const Mat3 r = rotation_onto(Vec3(1, 1, 1), Vec3(-std::cos(radians(30)), 0, std::sin(radians(30))));
  const Vec3 diagonal = Vec3(1, 1, 1).normalized(), tip(0.002, 2, -0.004);
  Scene scene;
  scene.add(acute_wedge(), true);
  scene.add(mapped(box({0, 0, 0}, {1, 1, 1}),
                   [&](const Vec3& p) { return Vec3(r * (p + 2 * diagonal * diagonal.dot(p)) + tip); }));
  for (const ContactPoint& p : scene.detect(reach).points) EXPECT_GT(p.gap, 0) << p.normal.transpose();
}

/// A block that is not convex and leans back from its lower front edge, and a corner that stands behind its front by 2
/// mm, and lower than it by little: both rest on a floor, and have sunk into it.
TEST(VertexFaceSearch, ACornerThatSankBelowAnAcuteEdgeStaysOnTheFaceThatItStandsAgainst) {
  const Shape leaning = mapped(cells({2, 1, 2}, [](int i, int, int k) { return i == 0 || k == 0; }),
                               [](const Vec3& p) { return Vec3(p.x() + 0.25 * p.z(), p.y(), p.z()); });
  const auto pushes_back = [&](double below) {
    Scene scene;
    scene.add(leaning, true);
    scene.add(mapped(turned(box({-1, -1, 0}, {0, 0, 1}), -20, Vec3::UnitZ(), {0, 0, 0}),
                     [&](const Vec3& p) { return Vec3(p.x() + 0.2 * p.z() + 0.002, p.y() + 0.5, p.z() - below); }));
    return std::ranges::any_of(scene.detect(reach).points,
                               [](const ContactPoint& p) { return p.gap < -1e-3 && p.normal.x() > 0.9; });
  };
  EXPECT_TRUE(pushes_back(-1e-5));
  EXPECT_TRUE(pushes_back(4e-5));
}

TEST(VertexFaceSearch, CornerOnAFaceTouchesOnceWhereverTheMeshRuns) {
  for (const Vec3& tip : {Vec3(1.9, 1.7, 0), Vec3(10.0 / 7, 4.0 / 6, 0), Vec3(10.0 / 7, 1.2, 0), Vec3(1.5, 1.5, 0)}) {
    for (double gap : {-0.02, -1e-6, 0.0, 0.009}) {
      Scene scene;
      scene.add(box({0, 0, -1}, {5, 4, 0}, {7, 6, 1}), true);
      scene.add(on_a_corner(tip + Vec3(0, 0, gap)));
      expect_one(scene.detect(reach), {0, 0, -1}, gap, tip);
    }
  }
}

/// A mountainside as a scan has it: a face that shares only a corner with another may rise to either side of its plane.
Shape rough_bed() {
  return mapped(box({0, 0, -1}, {4, 4, 0}, {4, 4, 1}), [](const Vec3& p) {
    const double rise = 0.25 * std::sin(2.3 * p.x() + 1.1 * p.y()) + 0.2 * std::sin(3.7 * p.y() - 1.9 * p.x());
    return Vec3(p.x(), p.y(), p.z() < -0.5 ? -2 : rise);
  });
}

TEST(VertexFaceSearch, CornerIsFoundInARoughBedWhereverItSinks) {
  const Shape bed = rough_bed();
  constexpr double deep = 2e-3;
  int places = 0;
  for (const SurfaceTriangle& triangle : bed.triangles) {
    const auto corner = [&](int k) { return bed.nodes[triangle.nodes[k]]; };
    const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    if (normal.z() < 0.5) continue;
    for (const Vec3& at : {Vec3(0.4, 0.35, 0.25), Vec3(0.8, 0.1, 0.1), Vec3(0.1, 0.8, 0.1), Vec3(0.1, 0.1, 0.8)}) {
      const Vec3 tip = at.x() * corner(0) + at.y() * corner(1) + at.z() * corner(2) - deep * normal;
      Scene scene;
      scene.add(bed, true);
      scene.add(on_a_corner(tip));
      const ContactSet& contacts = scene.detect(reach);
      const auto holds = [&](const ContactPoint& p) {
        return (p.normal + normal).norm() < 1e-9 && std::abs(p.gap + deep) < 1e-9;
      };
      EXPECT_TRUE(std::ranges::any_of(contacts.points, holds)) << tip.transpose();
      ++places;
    }
  }
  EXPECT_EQ(places, 4 * 2 * 4 * 4);
}

/// Below the line of a valley a corner projects onto neither side.
TEST(VertexFaceSearch, BothSidesOfAValleyHoldACornerThatSinksIntoItsLine) {
  const Shape valley = mapped(box({-1, 0, -1}, {1, 2, 0}, {2, 1, 1}), [](const Vec3& p) {
    return Vec3(p.x(), p.y(), p.z() < -0.5 ? -2 : std::abs(p.x()) / 2);
  });
  for (const double aside : {0.0, 2e-5, -2e-5}) {
    Scene scene;
    scene.add(valley, true);
    scene.add(on_a_corner({aside, 1.1, -1e-4}));
    int right = 0, left = 0;
    for (const ContactPoint& p : scene.detect(reach).points)
      if (p.gap < 0) ++(p.normal.x() > 0 ? right : left);
    EXPECT_EQ(right, 1) << aside;
    EXPECT_EQ(left, 1) << aside;
  }
}

/// A corner on one side of a valley, above its line, is over that side alone, and comes down on the other.
TEST(VertexFaceSearch, TheOtherSideOfAValleySeesACornerThatMayComeDownToIt) {
  const Shape foot = mapped(box({-1, 0, -1}, {1, 2, 0}, {2, 1, 1}), [](const Vec3& p) {
    return Vec3(p.x(), p.y(), p.z() < -0.5 ? -2 : std::max(0.0, 2 * p.x()));
  });
  const auto gap_to_floor = [&](double height) {
    Scene scene;
    scene.add(foot, true);
    scene.add(on_a_corner({height / 2, 1.1, height}));
    double gap = 1;
    for (const ContactPoint& p : scene.detect(reach).points)
      if (p.normal.z() < -0.999) gap = p.gap;
    return gap;
  };
  EXPECT_NEAR(gap_to_floor(0.5 * reach), 0.5 * reach, 1e-12);
  EXPECT_EQ(gap_to_floor(1.1 * reach), 1);
}

TEST(VertexFaceSearch, StiffnessOfAPointIsThatOfOneMeshCell) {
  Scene scene;
  scene.add(box({0, 0, -1}, {5, 4, 0}, {7, 6, 1}), true);
  scene.add(on_a_corner({1.9, 1.7, 0}));
  const ContactPoint& p = scene.detect(reach).points.at(0);
  EXPECT_NEAR(p.normal_stiffness, 10 * 1e9 * scene.size(1), 1);
  EXPECT_NEAR(p.shear_stiffness, 4 * 1e9 * scene.size(1), 1);
  EXPECT_EQ(p.cohesion, 0);
}

TEST(VertexFaceSearch, EdgeOnAFaceTouchesAtItsNodesAlone) {
  Scene scene;
  scene.add(box({0, 0, -1}, {5, 4, 0}, {7, 6, 1}), true);
  scene.add(on_an_edge({2.1, 1.3, -1e-5}));
  const ContactSet& contacts = scene.detect(reach);
  EXPECT_EQ(contacts.points.size(), 3u);
  for (const ContactPoint& p : contacts.points) {
    EXPECT_LT((p.normal - Vec3(0, 0, -1)).norm(), 1e-9);
    EXPECT_NEAR(p.gap, -1e-5, 1e-12);
  }
}

TEST(VertexFaceSearch, EdgeAcrossEdgeTouchesOnceWhereverTheMeshRuns) {
  for (double along : {0.3, 0.5, 0.72}) {  // 0.5: a node of the upper edge lies on the crossing
    for (double gap : {-1e-4, 0.005}) {
      Scene scene;
      // A roof with its top edge along x at z = 0; an edge along y across it.
      const Shape roof = turned(box({0, 0, 0}, {1, 1, 1}, {1, 3, 3}), 45, Vec3::UnitX(), {0, 0, -std::sqrt(2.0)});
      scene.add(roof, true);
      scene.add(on_an_edge({0.41, -along, gap}));
      expect_one(scene.detect(reach), {0, 0, -1}, gap, {0.41, 0, gap});
    }
  }
}

TEST(VertexFaceSearch, AnEdgeOverASharpEdgeIsHeldWhetherFacesTouchOrNot) {
  // A bar lies across another, inclined along itself and rolled onto one edge: its lower face is up to 4.2° from the
  // face below while the normal of the crossing edges is never farther than 3° from either.
  for (const double incline : {1.0, 1.9, 2.9}) {
    for (const double roll : {1.0, 2.0, 2.3, 2.5, 2.7, 2.9, 3.5}) {
      const Mat3 r =
          (Eigen::AngleAxisd(radians(incline), Vec3::UnitX()) * Eigen::AngleAxisd(radians(roll), Vec3::UnitY()))
              .matrix();
      const Vec3 lowest = r * Vec3(0.1, 0, 0), along = r.col(1);
      const Vec3 over_rim = lowest + along * ((-0.1 - lowest.y()) / along.y());  // where its edge crosses y = −0.1
      Scene scene;
      scene.add(box({-1, -0.1, -0.2}, {1, 0.1, 0}), true);
      scene.add(mapped(box({-0.1, -1, 0}, {0.1, 1, 0.2}),
                       [&](const Vec3& p) { return Vec3(r * p - Vec3(0, 0, over_rim.z() + 1e-5)); }));
      double deepest = 0;
      for (const ContactPoint& p : scene.detect(reach).points) {
        EXPECT_GT(-p.normal.z(), 0.99);
        deepest = std::max(deepest, -p.gap);
      }
      EXPECT_NEAR(deepest, 1e-5, 2e-8) << incline << " " << roll;
    }
  }
}

TEST(VertexFaceSearch, EdgesThatCrossPastTheirEndsDoNotTouch) {
  Scene scene;
  scene.add(turned(box({0, 0, 0}, {1, 1, 1}, {1, 3, 3}), 45, Vec3::UnitX(), {0, 0, -std::sqrt(2.0)}), true);
  scene.add(on_an_edge({1.3, -0.5, 0}));
  EXPECT_TRUE(scene.detect(reach).points.empty());
}

TEST(VertexFaceSearch, ACornerComesOffAtTheSharpEdge) {
  // The tip moves out over the sharp edge x = 5 of the slab: one upward contact until it is past, no sideways one.
  for (double x : {4.9, 4.999, 4.99999, 5.001, 5.02}) {
    Scene scene;
    scene.add(box({0, 0, -1}, {5, 4, 0}, {7, 6, 1}), true);
    scene.add(on_a_corner({x, 1.7, -1e-5}));
    const ContactSet& contacts = scene.detect(1e-4);
    for (const ContactPoint& p : contacts.points) {
      EXPECT_GT(-p.normal.z(), 0.5) << x;
    }
    EXPECT_EQ(contacts.points.size(), x < 5 ? 1u : 0u) << x;
  }
}

TEST(VertexFaceSearch, CornerSlidesOverTheSeamOfTwoSlabs) {
  for (double x = 1.99; x < 2.01; x += 0.0007) {
    for (double step : {0.0, 1e-6, -1e-6}) {
      Scene scene;
      scene.add(box({0, 0, -1}, {2, 3, 0}, {3, 4, 1}), true);
      scene.add(box({2, 0, -1}, {4, 3, step}, {2, 3, 1}), true);
      scene.add(on_a_corner({x, 1.3, -1e-5}));
      int touching = 0;  // an edge beside the tip may see the seam's edge from above
      for (const ContactPoint& p : scene.detect(1e-3).points) {
        if (p.gap > 0) continue;
        ++touching;
        EXPECT_LT((p.normal - Vec3(0, 0, -1)).norm(), 1e-9) << x;
      }
      EXPECT_EQ(touching, 1) << x << " " << step;
    }
  }
}

TEST(VertexFaceSearch, InsideTwoFacetsTheShallowerCounts) {
  // The tip is 0.05 below the top and 0.02 inside of the side x = 5: it came through the side, if it can have.
  Scene scene;
  scene.add(box({0, 0, -1}, {5, 4, 0}, {7, 6, 1}), true);
  const Vec3 diagonal = Vec3(1, 1, 1).normalized();
  const Mat3 r = rotation_onto(diagonal, Vec3(1, 0, 1));
  scene.add(mapped(box({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), [&](const Vec3& p) {
    return Vec3(r * (p + 1.5 * diagonal * diagonal.dot(p)) + Vec3(4.98, 1.7, -0.05));  // a spike
  }));
  int vertices = 0;
  for (const ContactPoint& p : scene.detect(reach).points) {
    const bool of_tip = p.key >> 62 == 1 && (scene.x[p.key >> 31 & 0x7fffffff] - Vec3(4.98, 1.7, -0.05)).norm() < 1e-9;
    if (!of_tip) continue;
    ++vertices;
    EXPECT_LT((p.normal - Vec3(-1, 0, 0)).norm(), 1e-9);
    EXPECT_NEAR(p.gap, -0.02, 1e-9);
  }
  EXPECT_EQ(vertices, 1);
}

TEST(VertexFaceSearch, BlockInAGrooveHasTheTwoPlanesNormalsOnly) {
  // Two wedges whose upper faces, at 45°, make a groove along y; a cube lies in it.
  const auto wedge = [](double sign) {
    Shape shape = box({0, 0, 0}, {1, 2, 1}, {3, 5, 3});
    for (Vec3& p : shape.nodes) p = Vec3(sign * p.x(), p.y(), p.z() * p.x() - 1 + p.z() * 1e-9 - (1 - p.z()));
    if (sign < 0) {
      for (SurfaceTriangle& t : shape.triangles) std::swap(t.nodes[0], t.nodes[1]);
    }
    return shape;
  };
  Scene scene;
  scene.add(mapped(wedge(1), [](const Vec3& p) { return Vec3(p + Vec3(0, 0, 1)); }), true);
  scene.add(mapped(wedge(-1), [](const Vec3& p) { return Vec3(p + Vec3(0, 0, 1)); }), true);
  scene.add(on_an_edge({0, 0.4, 0}, {3, 3, 3}));
  const ContactSet& contacts = scene.detect(reach);
  double right = 0, left = 0;
  for (const ContactPoint& p : contacts.points) {
    const Vec3 up = -p.normal;
    const double s = std::sqrt(0.5);
    if ((up - Vec3(-s, 0, s)).norm() < 1e-6) {
      right += p.area;
    } else if ((up - Vec3(s, 0, s)).norm() < 1e-6) {
      left += p.area;
    } else {
      ADD_FAILURE() << "false normal " << up.transpose() << " at " << p.position.transpose();
    }
  }
  EXPECT_NEAR(right, 1, 1e-6);
  EXPECT_NEAR(left, 1, 1e-6);
}

/// An L of three cells with their side 1, in the xz plane, one deep: cells (0,0), (1,0) and (0,1).
Shape hook(int n) {
  Shape shape = cells({2 * n, n, 2 * n}, [n](int i, int, int k) { return i < n || k < n; });
  return mapped(shape, [n](const Vec3& p) { return Vec3(p / n); });
}

TEST(VertexFaceSearch, HookedBlocksTouchInsideTheirCorners) {
  // The upper hook is turned over and hangs in the lower one: its horizontal arm lies on the lower's, their tips back
  // to back.
  Scene scene;
  scene.add(hook(2), true);
  scene.add(mapped(hook(2), [](const Vec3& p) { return Vec3(2 - p.x(), p.y(), 3 - p.z()); }));
  const ContactSet& contacts = scene.detect(reach);
  double down = 0, sideways = 0;
  for (const ContactPoint& p : contacts.points) {
    EXPECT_GE(p.gap, -1e-9);
    if ((p.normal - Vec3(0, 0, -1)).norm() < 1e-9) {
      down += p.area;
    } else if ((p.normal - Vec3(-1, 0, 0)).norm() < 1e-9) {
      sideways += p.area;
    } else {
      ADD_FAILURE() << "false normal " << p.normal.transpose() << " at " << p.position.transpose();
    }
  }
  EXPECT_NEAR(down, 2, 1e-9);
  EXPECT_NEAR(sideways, 1, 1e-9);
}

TEST(VertexFaceSearch, NeedlesAndCrushedFacetsMakeNoNaN) {
  Scene scene;
  Shape slab = box({0, 0, -1}, {5, 4, 0}, {7, 6, 1});
  scene.add(slab, true);
  Shape block = box({1, 1, 0}, {2, 2, 1}, {3, 3, 3});
  scene.add(block);
  for (int i = 0; i < scene.node_count(1); ++i) {  // a row of nodes falls onto the next, another nearly
    Vec3& p = scene.x[scene.first_node(1) + i];
    if (std::abs(p.x() - 4.0 / 3) < 1e-9) p.x() = 1;
    if (std::abs(p.x() - 5.0 / 3) < 1e-9) p.x() = 2 - 1e-13;
  }
  const ContactSet& contacts = scene.detect(reach);
  EXPECT_NEAR(total_area(contacts), 1, 1e-9);
  for (const ContactPoint& p : contacts.points) {
    EXPECT_TRUE(p.normal.allFinite() && p.position.allFinite() && std::isfinite(p.gap) && std::isfinite(p.area));
  }
  for (double w : contacts.weights) EXPECT_TRUE(std::isfinite(w));
}

}  // namespace
}  // namespace talus
