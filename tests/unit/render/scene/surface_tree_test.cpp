#include "render/scene/surface_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "render/scene/plane_section.hpp"
#include "render/scene/thinned_surface.hpp"

namespace talus {
namespace {

constexpr int cells = 60;

/// Hilly ground on a flat base, 60 × 60 m in cells of 1 m.
struct Hill {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;

  static double height(double x, double y) { return 12 + 3 * std::sin(x * 0.2) * std::cos(y * 0.15); }
  static int number(int level, int i, int k) { return (level * (cells + 1) + k) * (cells + 1) + i; }
  void quad(int a, int b, int c, int d) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
  Hill() {
    for (int level = 0; level < 2; ++level)
      for (int k = 0; k <= cells; ++k)
        for (int i = 0; i <= cells; ++i) points.push_back({1.0 * i, 1.0 * k, level * height(i, k)});
    for (int k = 0; k < cells; ++k)
      for (int i = 0; i < cells; ++i) {
        quad(number(1, i, k), number(1, i + 1, k), number(1, i + 1, k + 1), number(1, i, k + 1));
        quad(number(0, i, k), number(0, i, k + 1), number(0, i + 1, k + 1), number(0, i + 1, k));
      }
    for (int i = 0; i < cells; ++i) {
      quad(number(0, i, 0), number(0, i + 1, 0), number(1, i + 1, 0), number(1, i, 0));
      quad(number(0, i + 1, cells), number(0, i, cells), number(1, i, cells), number(1, i + 1, cells));
      quad(number(0, 0, i + 1), number(0, 0, i), number(1, 0, i), number(1, 0, i + 1));
      quad(number(0, cells, i), number(0, cells, i + 1), number(1, cells, i + 1), number(1, cells, i));
    }
  }
  RockSurface rock() const { return {points, triangles}; }
};

double areaOf(const PlaneSection& section) {
  double sum = 0;
  for (const FlatTriangle& t : section.triangles()) sum += (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
  return sum;
}

double volumeOf(const RockSurface& rock) {
  double six = 0;
  for (const auto& [a, b, c] : rock.triangles) six += rock.points[a].dot(rock.points[b].cross(rock.points[c]));
  return six / 6;
}

TEST(SurfaceTree, FindsAllThatAPlaneCrosses) {
  const Hill hill;
  const SurfaceTree tree(hill.rock());
  const Vec3 point(30, 30, 8);
  for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0.3, -0.5, 0.8), Vec3(-1, 2, 0.1)}) {
    EXPECT_NEAR(areaOf({tree, point, normal}), areaOf({hill.rock(), point, normal}), 1e-9);
    EXPECT_LT(tree.near_plane(point, normal).size(), hill.triangles.size() / 3) << "it looks at few";
  }
  EXPECT_TRUE(tree.near_plane({0, 0, 40}, Vec3::UnitZ()).empty());
}

TEST(SurfaceTree, KnowsWhatIsInsideAndWhatIsNear) {
  const SurfaceTree tree(Hill().rock());
  for (int i = 0; i < 200; ++i) {
    const Vec3 place(0.3 * i - 0.1, 60 - 0.3 * i, 2 + 0.07 * i);
    const bool within = place.x() > 0 && place.y() < 60 && place.z() < Hill::height(place.x(), place.y());
    if (std::abs(place.z() - Hill::height(place.x(), place.y())) < 0.1) continue;  // facets are no sine
    EXPECT_EQ(tree.holds(place), within) << place.transpose();
  }
  EXPECT_FALSE(tree.may_reach({30, 30, 5}, 2));
  EXPECT_TRUE(tree.may_reach({30, 30, 5}, 6));
  EXPECT_FALSE(tree.holds({30, 30, -1}));
}

TEST(ThinnedSurface, StaysClosedAndNearAndKeepsToThePoints) {
  const Hill hill;
  const std::vector<std::array<int, 3>> few = thinned(hill.rock(), 1500);
  EXPECT_LE(few.size(), 1500u);
  EXPECT_GT(few.size(), 1000u);
  std::map<std::pair<int, int>, int> sides;
  for (const auto& t : few)
    for (int i = 0; i < 3; ++i) ++sides[std::minmax(t[i], t[(i + 1) % 3])];
  for (const auto& [edge, count] : sides) EXPECT_EQ(count, 2);
  EXPECT_NEAR(volumeOf({hill.points, few}), volumeOf(hill.rock()), 2e-3 * volumeOf(hill.rock()));
  for (const Vec3& normal : {Vec3(1, 0.2, 0.1), Vec3(0.3, -0.5, 0.8)}) {
    const double all = areaOf({hill.rock(), {30, 30, 8}, normal});
    EXPECT_NEAR(areaOf({RockSurface{hill.points, few}, {30, 30, 8}, normal}), all, 5e-3 * all);
  }
}

TEST(ThinnedSurface, FlatFacesLoseTheirPointsFirst) {
  const Hill hill;
  std::size_t flat = 0;
  for (const auto& t : thinned(hill.rock(), 7500))
    flat += hill.points[t[0]].z() == 0 && hill.points[t[1]].z() == 0 && hill.points[t[2]].z() == 0 ? 1 : 0;
  EXPECT_LT(flat, 300u) << "of 7200 at the base";
}

TEST(ThinnedSurface, OfFewTrianglesIsTheSame) {
  const Hill hill;
  EXPECT_EQ(thinned(hill.rock(), hill.triangles.size()), hill.triangles);
}

}  // namespace
}  // namespace talus
