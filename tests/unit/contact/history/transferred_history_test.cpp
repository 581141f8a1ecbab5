#include <gtest/gtest.h>

#include <cmath>

#include "base/units.hpp"
#include "contact/contact_law.hpp"
#include "unit/contact/blocks.hpp"

/// A contact that goes on as another kind of contact transfers its force to it.
namespace talus {
namespace {

using testing::box;
using testing::mapped;
using testing::on_a_corner;
using testing::reach;
using testing::Scene;
using testing::Shape;

/// A sticking body: whoever touches keeps its shear force, and pushes by its spring.
struct Driven {
  Scene scene;
  double shear = 0, normal = 0, multiplier = 0;  // N, as the step begins
  double shear_energy = 0;                       // J
  int touching = 0;
  bool face_face = false;

  void detect() {
    shear = normal = multiplier = shear_energy = 0;
    touching = 0;
    face_face = false;
    Vec3 sum = Vec3::Zero();
    for (const ContactPoint& p : scene.detect(reach).points) {
      face_face = face_face || p.area > 0;
      if (p.gap > 0) continue;
      ++touching;
      sum += p.shear_start;
      shear_energy += shear_spring_energy(p, p.shear_start);
      multiplier += p.multiplier;
      normal += -p.gap * p.normal_stiffness;
    }
    shear = sum.norm();
  }
  /// `given` [N]: the shear set on what touches, in all, with a multiplier of 2 N; 0: all keep what they have.
  void accept(const Vec3& given = Vec3::Zero()) {
    std::vector<ContactOutcome> outcomes(scene.contacts.points.size());
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      ContactPoint& p = scene.contacts.points[i];
      p.mode = p.gap > 0 ? ContactMode::open : ContactMode::stick;
      outcomes[i].gap = p.gap;
      if (p.gap > 0) continue;
      outcomes[i].multiplier = given.isZero() ? p.multiplier : 2.0 / touching;
      outcomes[i].normal_force = outcomes[i].multiplier - p.gap * p.normal_stiffness;
      outcomes[i].shear_force = given.isZero() ? p.shear_start : Vec3(given / touching);
    }
    scene.detector().accept(scene.contacts, outcomes);
  }
};

/// A cube of 4 cells a side on a slab of another mesh, tilted about its lower edge along y and 1e-5 deep there.
Shape tilted(double degrees) {
  const Mat3 r = Eigen::AngleAxisd(radians(-degrees), Vec3::UnitY()).toRotationMatrix();
  return mapped(box({0, 0, 0}, {1, 1, 1}, {4, 4, 4}, true),
                [&](const Vec3& p) { return Vec3(r * p + Vec3(2, 1.1, -1e-5)); });
}

void turn_to(Scene& scene, double degrees) {
  const Shape shape = tilted(degrees);
  std::copy(shape.nodes.begin(), shape.nodes.end(), scene.x.begin() + scene.first_node(1));
}

Driven tipping_cube(double degrees) {
  Driven cube;
  cube.scene.add(box({0, 0, -1}, {5, 4, 0}, {7, 6, 1}), true);
  cube.scene.add(tilted(degrees));
  return cube;
}

/// Turns the cube by 0.1° a step: tractions stay while its face is in contact with the slab's (the area is seen under a
/// changing angle), forces where it ceases or begins to, but for what softer springs could not hold without more
/// energy.
void expect_continuous_shear(Driven& cube, double from, double to) {
  const double turn = to > from ? 0.1 : -0.1;
  double shear = 5, multiplier = 2, energy = cube.shear_energy;
  for (double angle = from + turn; (to - angle) * turn > 0; angle += turn) {
    const bool faced = cube.face_face;
    turn_to(cube.scene, angle);
    cube.detect();
    const bool is_softer = cube.face_face && !faced;
    if (is_softer) {
      EXPECT_LT(cube.shear, shear);
      EXPECT_NEAR(cube.shear_energy, energy, 1e-9 * energy);
    } else {
      EXPECT_NEAR(cube.shear, shear, faced && cube.face_face ? 5e-5 * shear : 1e-9) << angle;
    }
    EXPECT_NEAR(cube.multiplier, multiplier, faced && cube.face_face ? 5e-5 * multiplier : 1e-9) << angle;
    shear = cube.shear;
    energy = cube.shear_energy;
    multiplier = cube.multiplier;
    cube.accept();
  }
}

TEST(TransferredHistory, ACubeThatTipsOverItsEdgeKeepsItsShear) {
  Driven cube = tipping_cube(2.5);
  cube.detect();
  EXPECT_TRUE(cube.face_face);
  cube.accept({0, 5, 0});
  expect_continuous_shear(cube, 2.5, 4);
  EXPECT_FALSE(cube.face_face);
  EXPECT_EQ(cube.touching, 5);
}

TEST(TransferredHistory, ACubeThatTipsOverItsEdgePushesAsBefore) {
  Driven cube = tipping_cube(2.9);
  cube.detect();
  const double before = cube.normal;
  cube.accept();
  turn_to(cube.scene, 3.05);
  cube.detect();
  EXPECT_FALSE(cube.face_face);
  EXPECT_NEAR(cube.normal, before, 1e-3 * before);  // five times without what is left out of the gap
}

/// A corner that slides from one facet on to the next is nearer to the plane of that one, or less near, than it was to
/// the other's, though the features have the same names.
TEST(TransferredHistory, AGapThatIsMeasuredAnewNeitherPressesNorRelieves) {
  for (const bool deforms : {true, false}) {
    Driven cube;
    cube.scene.deforms = deforms;
    cube.scene.add(box({0, 0, -1}, {5, 4, 0}, {7, 6, 1}), true);
    cube.scene.add(box({1, 1, -1e-5}, {2, 2, 1 - 1e-5}, {1, 1, 1}));
    cube.detect();
    const double before = cube.normal;
    EXPECT_GT(before, 0);
    cube.accept();
    cube.scene.move(1, {0, 0, -1e-4});
    cube.detect();
    EXPECT_NEAR(cube.normal, deforms ? before : 11 * before, 1e-6 * before);
    cube.accept();
    cube.scene.move(1, {0, 0, 1e-4});
    cube.detect();
    EXPECT_NEAR(cube.normal, before, 1e-6 * before);
    EXPECT_NEAR(cube.scene.contacts.points[0].initial_interference, 0, 1e-12);
  }
}

TEST(TransferredHistory, ACubeThatRocksBackKeepsItsShear) {
  Driven cube = tipping_cube(4);
  cube.detect();
  EXPECT_FALSE(cube.face_face);
  cube.accept({0, 5, 0});
  cube.detect();
  cube.accept();
  expect_continuous_shear(cube, 4, 2);
  EXPECT_TRUE(cube.face_face);
}

TEST(TransferredHistory, WhatIsOpenTakesNoTractionOfWhatBearsIt) {
  Driven cube = tipping_cube(2.5);
  cube.detect();
  const auto points = static_cast<int>(cube.scene.contacts.points.size());
  EXPECT_TRUE(cube.face_face);
  EXPECT_GT(points, cube.touching);
  cube.accept({0, 5, 0});
  cube.detect();
  for (const ContactPoint& p : cube.scene.contacts.points) EXPECT_TRUE(p.gap <= 0 || p.shear_start.norm() < 1e-9);
  EXPECT_NEAR(cube.shear, 5, 1e-9);
}

TEST(TransferredHistory, AFaceOfWhichMoreComesToLieHoldsNoMore) {
  Driven cube;
  cube.scene.add(box({0, 0, -1}, {5, 4, 0}, {7, 6, 1}), true);
  cube.scene.add(box({-0.8, 1.1, -1e-5}, {0.2, 2.1, 1 - 1e-5}, {4, 4, 4}));
  cube.detect();
  cube.accept({0, 5, 0});
  cube.detect();
  const auto normal_energy = [&] {
    double sum = 0;
    for (const ContactPoint& p : cube.scene.contacts.points)
      sum += 0.5 * p.normal_stiffness * std::pow(std::min(0.0, p.gap), 2);
    return sum;
  };
  const double normal = normal_energy(), shear = cube.shear_energy;
  for (int step = 0; step < 7; ++step) {
    cube.accept();
    cube.scene.move(1, {0.1, 0, 0});
    cube.detect();
    EXPECT_NEAR(normal_energy(), normal, 1e-6 * normal) << step;
    EXPECT_NEAR(cube.shear_energy, shear, 1e-6 * shear) << step;
  }
}

/// A slab whose surface bends by `degrees` at x = 2, down or up.
Shape bent(double degrees) {
  const double slope = std::tan(radians(degrees));
  return mapped(box({0, 0, -1}, {4, 4, 0}, {6, 5, 1}), [&](const Vec3& p) {
    return Vec3(p + Vec3(0, 0, p.z() < -0.5 || p.x() < 2 ? 0 : slope * (2 - p.x())));
  });
}

TEST(TransferredHistory, AVertexThatPassesOverABendKeepsItsShear) {
  for (double degrees : {-20.0, -1.0, 1.0, 20.0}) {
    const auto height = [&](double x) { return x < 2 ? 0 : std::tan(radians(degrees)) * (2 - x); };
    Driven cube;
    cube.scene.add(bent(degrees), true);
    double x = 1.9;
    cube.scene.add(on_a_corner({x, 1.7, -1e-5}));
    cube.detect();
    cube.accept({0, 5, 0});
    for (int step = 0; step < 40; ++step) {
      const double next = x + 0.005;
      cube.scene.move(1, {next - x, 0, height(next) - height(x)});
      x = next;
      cube.detect();
      const bool in_valley = degrees == -20 && std::abs(x - 2) < 1e-5;
      EXPECT_EQ(cube.touching, in_valley ? 2 : 1) << degrees << " at " << x;
      EXPECT_NEAR(cube.shear, 5, 1e-9) << degrees << " at " << x;
      cube.accept();
    }
  }
}

TEST(TransferredHistory, ACrossingHandsOnToTheVertexAtTheEdgesEndAndTakesItBack) {
  // The edge y of the upper cube lies across the top edge x of a roof, leans by 10° and slides along itself until its
  // lower end, a corner, comes over that edge: from then on the corner slides down the other side.
  const Mat3 roof = Eigen::AngleAxisd(radians(45), Vec3::UnitX()).toRotationMatrix();
  const Mat3 lean = Eigen::AngleAxisd(radians(10), Vec3::UnitX()).toRotationMatrix() *
                    Eigen::AngleAxisd(radians(-45), Vec3::UnitY()).toRotationMatrix();
  const Vec3 along = lean.col(1), down = Vec3(0, 1, -1).normalized();
  const auto at = [&](double s) {  // where its lower end is, up to the top edge and past it
    return Vec3(Vec3(0.41, 0, -1e-5) + s * (s < 0 ? along : down));
  };
  Driven cube;
  const Vec3 top_edge(0, 0, -std::sqrt(2.0));
  cube.scene.add(mapped(box({0, 0, 0}, {1, 1, 1}, {3, 3, 3}), [&](const Vec3& p) { return Vec3(roof * p + top_edge); }),
                 true);
  cube.scene.add(
      mapped(box({0, 0, 0}, {1, 1, 1}, {2, 2, 2}), [&](const Vec3& p) { return Vec3(lean * p + at(-0.05)); }));
  cube.detect();
  ASSERT_EQ(cube.touching, 1);
  ASSERT_EQ(cube.scene.contacts.points[0].key >> 62, 3u);
  cube.accept({5, 0, 0});
  int kinds = 0;
  double s = -0.05;
  for (double step : {0.004, -0.004}) {
    for (int i = 0; i < 20; ++i) {
      cube.scene.move(1, at(s + step) - at(s));
      s += step;
      cube.detect();
      EXPECT_EQ(cube.touching, 1) << s;
      EXPECT_NEAR(cube.shear, 5, 1e-9) << s;
      if (cube.touching > 0) kinds |= 1 << (cube.scene.contacts.points[0].key >> 62);
      cube.accept();
    }
  }
  EXPECT_EQ(kinds, 1 << 1 | 1 << 3);  // it was both
}

TEST(TransferredHistory, WhatIsFarAwayTakesNothing) {
  // The corner's contact ends; at the same time another corner, two sizes away, comes down.
  Driven cube;
  cube.scene.add(box({0, 0, -1}, {5, 4, 0}, {7, 6, 1}), true);
  cube.scene.add(on_a_corner({1.7, 1.7, -1e-5}));
  cube.detect();
  cube.accept({0, 5, 0});
  cube.scene.move(1, {1.2, 0, 0.5});
  cube.detect();
  EXPECT_EQ(cube.touching, 0);
  const Shape other = on_a_corner({2.9, 1.7, -1e-5});
  std::copy(other.nodes.rbegin(), other.nodes.rend(), cube.scene.x.begin() + cube.scene.first_node(1));
  cube.detect();
  EXPECT_EQ(cube.touching, 1);
  EXPECT_EQ(cube.shear, 0);
}

}  // namespace
}  // namespace talus
