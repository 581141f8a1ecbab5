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

/// Its first triangle becomes a dent.
Shape dented(Shape shape) {
  const std::array<int, 3> around = shape.triangles[0].nodes;
  const int bottom = static_cast<int>(shape.nodes.size());
  shape.nodes.push_back(0.7 / 3 * (shape.nodes[around[0]] + shape.nodes[around[1]] + shape.nodes[around[2]]));
  shape.triangles.erase(shape.triangles.begin());
  for (int k = 0; k < 3; ++k) shape.triangles.push_back({{around[k], around[(k + 1) % 3], bottom}, -1});
  return shape;
}

/// Blocks of 0.4 to 1 m, turned and stretched at random.
class Pebbles {
 public:
  explicit Pebbles(std::vector<Shape> shapes) : shapes_(std::move(shapes)) {}
  Shape next() {
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(normal_(random_), normal_(random_), normal_(random_), normal_(random_)).normalized();
    const Vec3 size(length_(random_), length_(random_), length_(random_));
    return mapped(shapes_[random_() % shapes_.size()],
                  [&](const Vec3& p) { return Vec3(turn * p.cwiseProduct(size)); });
  }
  Vec3 direction() { return Vec3(normal_(random_), normal_(random_), normal_(random_)).normalized(); }

 private:
  std::vector<Shape> shapes_;
  std::mt19937 random_{1};
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> length_{0.2, 0.5};
};

Pebbles convex_pebbles() { return Pebbles({tetrahedron(), octahedron(), testing::box({-1, -1, -1}, {1, 1, 1})}); }

double lowest(const Scene& scene, int body, const Vec3& direction) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < scene.node_count(body); ++i)
    least = std::min(least, direction.dot(scene.x[scene.first_node(body) + i]));
  return least;
}

double highest(const Scene& scene, int body, const Vec3& direction) { return -lowest(scene, body, -direction); }

/// Between two bodies along the best of all normals of triangles that have their whole body on one side. [m]
double separation_along_faces(const Scene& scene) {
  double widest = -std::numeric_limits<double>::infinity();
  for (const int own : {0, 1})
    for (const SurfaceTriangle& t : scene.bodies()[own].surface->triangles) {
      const auto at = [&](int k) { return scene.x[scene.first_node(own) + t.nodes[k]]; };
      const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
      if (highest(scene, own, normal) > normal.dot(at(0)) + 1e-9) continue;
      widest = std::max(widest, lowest(scene, 1 - own, normal) - normal.dot(at(0)));
    }
  return widest;
}

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
    const Vec3 along = across.normalized();
    widest = std::max({widest, lowest(scene, 0, along) - highest(scene, 1, along),
                       lowest(scene, 1, along) - highest(scene, 0, along)});
  };
  for (const Vec3& u : of_first)
    for (const Vec3& w : of_second) look_along(u.cross(w));
  for (const auto* of_body : {&of_first, &of_second})
    for (const Vec3& u : *of_body)
      for (const Vec3& w : *of_body) look_along(u.cross(w));
  return widest;
}

/// Two pebbles that have been far from each other, and come to where they are this far apart [m].
Scene brought_together(Pebbles& pebbles, double apart, double (*separation)(const Scene&) = separation,
                       bool single_body = true) {
  Scene scene;
  scene.single_body = single_body;
  scene.add(pebbles.next());
  scene.add(pebbles.next());
  const Vec3 direction = pebbles.direction();
  scene.move(1, 10 * direction);
  scene.detect(0.1);
  testing::accept_as_stuck(scene);
  double gap = separation(scene);
  for (int moves = 0; std::abs(gap - apart) > 1e-6 && moves < 100; ++moves) {
    scene.move(1, (apart - gap) / 2 * direction);
    gap = separation(scene);
  }
  return scene;
}

/// The number of contacts of 400 pairs that are apart, and of as many that lie in each other by a little and by more.
int contacts_that_are_no_deeper_than_bodies(Pebbles pebbles, double (*separation)(const Scene&)) {
  int contacts = 0;
  for (int i = 0; i < 400; ++i)
    for (const double apart : {0.01, -1e-3, -0.01, -0.02}) {
      Scene scene = brought_together(pebbles, apart, separation);
      const double tolerance = 1.1e-4 * std::min(scene.size(0), scene.size(1));  // the edge tolerance, and rounding
      for (const ContactPoint& p : scene.detect(0.15).points) {
        EXPECT_GT(p.gap - p.initial_interference, std::min(separation(scene), 0.0) - tolerance) << "pair " << i;
        ++contacts;
      }
    }
  return contacts;
}

TEST(SeparatingAxis, NoContactIsDeeperThanTheBodiesAre) {
  EXPECT_GT(contacts_that_are_no_deeper_than_bodies(convex_pebbles(), separation), 1600);
}

TEST(SeparatingAxis, NoContactOfBodiesWithADentIsDeeperThanOneOfTheirOuterFacesSays) {
  const Shape cube = testing::box({-1, -1, -1}, {1, 1, 1});
  const Pebbles pebbles({dented(tetrahedron()), dented(octahedron()), dented(cube), cube, tetrahedron()});
  EXPECT_GT(contacts_that_are_no_deeper_than_bodies(pebbles, separation_along_faces), 1600);
}

/// Of 400 pairs that lie in each other by a millimetre, how many have a contact that is as deep.
int pairs_with_a_contact_as_deep(bool single_bodies) {
  Pebbles pebbles = convex_pebbles();
  int told = 0;
  for (int i = 0; i < 400; ++i) {
    Scene scene = brought_together(pebbles, -1e-3, separation, single_bodies);
    const auto is_as_deep = [](const ContactPoint& p) {
      return std::abs(p.gap - p.initial_interference + 1e-3) < 1e-4;
    };
    const auto& points = scene.detect(0.15).points;
    told += std::any_of(points.begin(), points.end(), is_as_deep);
  }
  return told;
}

TEST(SeparatingAxis, WhereBodiesAreInEachOtherAContactTellsHowDeep) {
  EXPECT_EQ(pairs_with_a_contact_as_deep(true), 400);
}

TEST(SeparatingAxis, SoDoesOneOfBodiesThatMayDeform) { EXPECT_EQ(pairs_with_a_contact_as_deep(false), 400); }

}  // namespace
}  // namespace talus
