#include "solve/dynamics/free_flight.hpp"

#include <gtest/gtest.h>

#include <array>

#include "effects/inertia.hpp"
#include "support/momenta.hpp"
#include "support/solver_scenes.hpp"

namespace talus {
namespace {

/// Three boxes of one kind in a row, the third of which is fixed, and a step in which they turn and lose momentum.
class FreeFlightTest : public testing::TestWithParam<BodyKind> {
 protected:
  FreeFlightTest()
      : set_(test::rock_project(0, {}),
             test::block_system({test::box_block("A", Vec3(0, 0, 0), Vec3(1, 2, 3), GetParam()),
                                 test::box_block("B", Vec3(1, 0, 0), Vec3(2, 1, 1), GetParam()),
                                 test::box_block("C", Vec3(2, 0, 0), Vec3(3, 1, 1), BodyKind::fixed)})),
        flight_(set_) {
    for (const int b : set_.moving) spin(b, Vec3(3, -1 - b, 2));
  }
  void spin(int b, const Vec3& turn) {
    const Body& body = set_.bodies[b];
    if (body.kind == BodyKind::rigid) {
      RigidBody& rigid = set_.rigid[body.rigid];
      rigid.angular_momentum += rigid.inertia_now() * turn;
      set_.nodes.velocity[rigid.centre] += turn.cross(set_.nodes.position[rigid.centre]);
      return;
    }
    for (int n = body.first_free(); n < body.first_free() + body.free_count(); ++n)
      set_.nodes.velocity[n] += turn.cross(set_.nodes.position[n]);
  }
  /// Changes what a body does by this velocity gradient about its centroid; of a rigid one the spin alone.
  void change(int b, const Vec3& centroid, const Mat3& gradient) {
    const Body& body = set_.bodies[b];
    if (body.kind == BodyKind::rigid) {
      const Mat3 skew = 0.5 * (gradient - gradient.transpose());
      set_.rigid[body.rigid].angular_momentum +=
          set_.rigid[body.rigid].inertia_now() * Vec3(skew(2, 1), skew(0, 2), skew(1, 0));
      return;
    }
    for (int n = body.first_free(); n < body.first_free() + body.free_count(); ++n)
      set_.nodes.velocity[n] += gradient * (set_.nodes.position[n] - centroid);
  }
  /// A step in which these two push each other, or nobody.
  void step(int a = -1, int b = -1) {
    contacts_.points.clear();
    outcomes_.clear();
    if (a >= 0) {
      ContactPoint point{};
      point.bodies[0] = a;
      point.bodies[1] = b;
      contacts_.points = {point};
      outcomes_ = {{.normal_force = 5}};
    }
    flight_.note_start(contacts_, outcomes_);
  }
  double kinetic() const { return Inertia::kinetic_energy(set_); }

  const Vec3 middle_{0.5, 1, 1.5};  // m, of the first
  BodySet set_;
  FreeFlight flight_;
  IntegrationReserve reserve_{set_};
  ContactSet contacts_;
  std::vector<ContactOutcome> outcomes_;
};

TEST_P(FreeFlightTest, KeepsAngularMomentum) {
  const Mat3 lost = Mat3{{0, 0.02, -0.01}, {-0.02, 0, 0.03}, {0.01, -0.03, 0}};
  for (const bool together : {false, true}) {
    const Vec3 before = test::momenta(set_).angular;
    together ? step(0, 1) : step();
    change(0, middle_, lost);
    EXPECT_GT((test::momenta(set_).angular - before).norm(), 1e-3 * before.norm());
    flight_.end_step(reserve_);
    EXPECT_LT((test::momenta(set_).angular - before).norm(), 1e-12 * before.norm()) << together;
  }
}

/// What two bodies do beside their common motion pays for it.
TEST_P(FreeFlightTest, MakesNoEnergy) {
  for (const double sign : {-1, 1}) {
    step(0, 1);
    change(0, middle_, sign * Mat3{{0, 0.02, -0.01}, {-0.02, 0, 0.03}, {0.01, -0.03, 0}});
    const double before = kinetic();
    flight_.end_step(reserve_);
    EXPECT_LE(kinetic(), before * (1 + 1e-12));
  }
}

TEST_P(FreeFlightTest, LeavesAloneWhatIsHeld) {
  step(1, 2);
  change(1, {1.5, 0.5, 0.5}, Mat3{{0, 0.5, 0}, {-0.5, 0, 0}, {0, 0, 0}});
  const double before = Inertia::kinetic_energy(set_, std::array{1});
  flight_.end_step(reserve_);
  EXPECT_EQ(Inertia::kinetic_energy(set_, std::array{1}), before);
  EXPECT_TRUE(flight_.flies(0));
  EXPECT_FALSE(flight_.flies(1));
}

/// Newmark's method leaves −1/3 of what is too fast for the step. Slow vibrations go on.
TEST_P(FreeFlightTest, CalmsWhatRings) {
  if (GetParam() == BodyKind::rigid) return;
  const Mat3 stretching = Mat3(Vec3(0.2, -0.1, 0.3).asDiagonal());
  const Body& body = set_.bodies[0];
  for (int n = body.first_free(); n < body.first_free() + body.free_count(); ++n) set_.nodes.velocity[n].setZero();
  change(0, middle_, stretching);
  const double energy = Inertia::kinetic_energy(set_, std::array{0});
  step();
  flight_.end_step(reserve_);
  EXPECT_NEAR(Inertia::kinetic_energy(set_, std::array{0}), energy, 1e-12 * energy);
  step();
  change(0, middle_, -2 * stretching);
  flight_.end_step(reserve_);
  EXPECT_NEAR(Inertia::kinetic_energy(set_, std::array{0}), energy / 9, 1e-12 * energy);
}

INSTANTIATE_TEST_SUITE_P(Bodies, FreeFlightTest,
                         testing::Values(BodyKind::rigid, BodyKind::affine, BodyKind::tetrahedra),
                         [](const auto& body) { return std::string(to_string(body.param)); });

}  // namespace
}  // namespace talus
