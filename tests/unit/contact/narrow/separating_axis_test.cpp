#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "unit/contact/blocks.hpp"

/// Contacts of two convex bodies against how far these are apart, or how deep in each other.
namespace talus {
namespace {

using testing::mapped;
using testing::Scene;
using testing::Shape;

Shape tetrahedron() {
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
          {{{0, 1, 2}, -1}, {{0, 3, 1}, -1}, {{0, 2, 3}, -1}, {{1, 3, 2}, -1}}};
}

Shape octahedron() {
  Shape shape{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, {}};
  for (const std::array<int, 3>& nodes :
       {std::array{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}})
    shape.triangles.push_back({nodes, -1});
  return shape;
}

/// Convex blocks of 0.4 to 1 m, turned and stretched at random.
class Pebbles {
 public:
  Shape next() {
    const Shape shapes[] = {tetrahedron(), octahedron(), testing::box({-1, -1, -1}, {1, 1, 1})};
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(normal_(random_), normal_(random_), normal_(random_), normal_(random_)).normalized();
    const Vec3 size(length_(random_), length_(random_), length_(random_));
    return mapped(shapes[random_() % 3], [&](const Vec3& p) { return Vec3(turn * p.cwiseProduct(size)); });
  }
  Vec3 direction() { return Vec3(normal_(random_), normal_(random_), normal_(random_)).normalized(); }

 private:
  std::mt19937 random_{1};
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> length_{0.2, 0.5};
};

/// Between two bodies along the best of all normals of triangles and all directions across two of their edges: no two
/// convex bodies that are apart lie in each other along all of them. [m]
double separation(const Scene& scene) {
  const auto edges = [&](int body) {
    std::vector<Vec3> all;
    for (const SurfaceEdge& e : scene.bodies()[body].surface->edges)
      all.push_back(scene.x[scene.first_node(body) + e.nodes[1]] - scene.x[scene.first_node(body) + e.nodes[0]]);
    return all;
  };
  const std::vector<Vec3> of_first = edges(0), of_second = edges(1);
  double widest = -std::numeric_limits<double>::infinity();
  const auto look_along = [&](const Vec3& across) {
    if (across.norm() < 1e-6) return;
    double lowest[2], highest[2];
    for (int b = 0; b < 2; ++b) {
      lowest[b] = std::numeric_limits<double>::infinity();
      highest[b] = -lowest[b];
      for (int i = 0; i < scene.node_count(b); ++i) {
        const double height = across.normalized().dot(scene.x[scene.first_node(b) + i]);
        lowest[b] = std::min(lowest[b], height);
        highest[b] = std::max(highest[b], height);
      }
    }
    widest = std::max({widest, lowest[0] - highest[1], lowest[1] - highest[0]});
  };
  for (const Vec3& u : of_first)
    for (const Vec3& w : of_second) look_along(u.cross(w));
  for (const auto* of_body : {&of_first, &of_second})
    for (const Vec3& u : *of_body)
      for (const Vec3& w : *of_body) look_along(u.cross(w));
  return widest;
}

/// Two pebbles that have been far from each other, and come to where they are this far apart [m].
Scene brought_together(Pebbles& pebbles, double apart) {
  Scene scene;
  scene.single_body = true;
  scene.add(pebbles.next());
  scene.add(pebbles.next());
  const Vec3 direction = pebbles.direction();
  scene.move(1, 10 * direction);
  scene.detect(0.1);
  testing::accept_as_stuck(scene);
  for (double gap = separation(scene); std::abs(gap - apart) > 1e-6; gap = separation(scene))
    scene.move(1, (apart - gap) / 2 * direction);
  return scene;
}

TEST(SeparatingAxis, NoContactIsDeeperThanTheBodiesAre) {
  Pebbles pebbles;
  int contacts = 0;
  for (int i = 0; i < 400; ++i)
    for (const double apart : {0.01, -1e-3}) {
      Scene scene = brought_together(pebbles, apart);
      const double tolerance = 1.1e-4 * std::min(scene.size(0), scene.size(1));  // the edge tolerance, and rounding
      for (const ContactPoint& p : scene.detect(0.15).points) {
        EXPECT_GT(p.gap - p.initial_interference, std::min(apart, 0.0) - tolerance) << "pair " << i;
        ++contacts;
      }
    }
  EXPECT_GT(contacts, 800);
}

TEST(SeparatingAxis, WhereBodiesAreInEachOtherAContactTellsHowDeep) {
  Pebbles pebbles;
  int told = 0;
  for (int i = 0; i < 400; ++i) {
    Scene scene = brought_together(pebbles, -1e-3);
    const auto is_as_deep = [](const ContactPoint& p) {
      return std::abs(p.gap - p.initial_interference + 1e-3) < 1e-4;
    };
    const auto& points = scene.detect(0.15).points;
    told += std::any_of(points.begin(), points.end(), is_as_deep);
  }
  EXPECT_EQ(told, 400);
}

}  // namespace
}  // namespace talus
