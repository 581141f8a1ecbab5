#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/units.hpp"
#include "unit/contact/blocks.hpp"

namespace talus {
namespace {

using testing::box;
using testing::mapped;
using testing::reach;
using testing::Scene;
using testing::total_area;
constexpr double pi = 3.14159265358979323846;

Scene bonded_block(double gap = 0) {
  Scene scene;
  scene.laws = {{.friction = 0.6, .residual_friction = 0.2, .cohesion = 2e5, .tensile_strength = 5e4}};
  scene.add(box({0, 0, -1}, {5, 4, 0}, {7, 6, 1}), true);
  scene.add(box({1.1, 1.2, gap}, {2.1, 2.2, 1 + gap}, {3, 3, 3}, true));
  return scene;
}

/// A block that was apart, and is found 8 mm deep.
Scene block_found_deep() {
  Scene scene = bonded_block(0.5);
  scene.detect(reach);
  scene.detector().accept(scene.contacts, {});
  scene.move(1, {0, 0, -0.508});
  scene.detect(reach);
  return scene;
}

std::vector<ContactOutcome> outcomes(const ContactSet& contacts, const Vec3& traction, ContactMode mode, Scene& scene) {
  std::vector<ContactOutcome> all(contacts.points.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    scene.contacts.points[i].mode = mode;
    all[i].shear_force = traction * (contacts.points[i].area > 0 ? contacts.points[i].area : 1);
    all[i].gap = contacts.points[i].gap;
  }
  return all;
}

TEST(ContactMemory, FirstDetectionBondsWhatTouches) {
  Scene scene = bonded_block();
  for (int again = 0; again < 2; ++again) {  // a step that was cut detects twice before it is accepted
    const ContactSet& contacts = scene.detect(reach);
    double cohesion = 0, tension = 0;
    for (const ContactPoint& p : contacts.points) {
      EXPECT_TRUE(p.bonded);
      EXPECT_EQ(p.friction, 0.6);
      cohesion += p.cohesion;
      tension += p.tension;
    }
    EXPECT_NEAR(cohesion, 2e5, 1e-6);  // over 1 m²
    EXPECT_NEAR(tension, 5e4, 1e-6);
  }
}

TEST(ContactMemory, WhatIsApartAtFirstIsNotBondedNorIsAJointWithoutStrength) {
  Scene apart = bonded_block(2e-3 * bonded_block().size(1));
  for (const ContactPoint& p : apart.detect(reach).points) EXPECT_FALSE(p.bonded);
  EXPECT_FALSE(apart.contacts.points.empty());

  Scene loose = bonded_block();
  loose.laws = {{.friction = 0.6}};
  for (const ContactPoint& p : loose.detect(reach).points) EXPECT_FALSE(p.bonded);
  EXPECT_FALSE(loose.contacts.points.empty());
}

TEST(ContactMemory, ContactsMadeLaterAreNotBonded) {
  Scene scene = bonded_block(0.5);
  scene.detect(reach);
  scene.detector().accept(scene.contacts, {});
  scene.move(1, {0, 0, -0.5});
  const ContactSet& contacts = scene.detect(reach);
  EXPECT_NEAR(total_area(contacts), 1, 1e-12);
  for (const ContactPoint& p : contacts.points) {
    EXPECT_FALSE(p.bonded);
    EXPECT_EQ(p.friction, 0.6);  // never bonded, so nothing is broken
  }
}

TEST(ContactMemory, AContactFoundDeepPushesOnlyAgainstWhatComesOnTop) {
  Scene scene = block_found_deep();
  ASSERT_FALSE(scene.contacts.points.empty());
  for (const ContactPoint& p : scene.contacts.points) {
    EXPECT_NEAR(p.initial_interference, 0.008, 1e-12);
    EXPECT_NEAR(p.gap, 0, 1e-12);
  }
  // Pressed 0.001 deeper, it remembers what it left out; lifted off and set down again, it starts anew.
  auto all = outcomes(scene.contacts, Vec3::Zero(), ContactMode::stick, scene);
  scene.detector().accept(scene.contacts, all);
  scene.move(1, {0, 0, -0.001});
  for (const ContactPoint& p : scene.detect(reach).points) EXPECT_NEAR(p.gap, -0.001, 1e-12);
  scene.move(1, {0, 0, 0.011});
  all = outcomes(scene.detect(reach), Vec3::Zero(), ContactMode::open, scene);
  scene.detector().accept(scene.contacts, all);
  scene.move(1, {0, 0, -0.002});
  ASSERT_FALSE(scene.detect(reach).points.empty());
  for (const ContactPoint& p : scene.contacts.points) EXPECT_NEAR(p.gap, 0, 1e-12);
}

TEST(ContactMemory, AContactFoundDeepDoesNotPushAsThoseWithOtherNormalsDo) {
  Scene scene;
  scene.add(box({-3, -3, -1}, {3, 3, 0}), true);
  scene.add(box({0, 0, -4e-4}, {1, 1, 1 - 4e-4}));
  scene.add(box({1.1, -3, 0.2}, {3, 3, 2}), true);
  scene.detect(reach);
  const auto pressed = outcomes(scene.contacts, Vec3::Zero(), ContactMode::stick, scene);
  scene.detector().accept(scene.contacts, pressed);
  scene.move(1, {0.1004, 0, 0});
  int beside = 0;
  for (const ContactPoint& p : scene.detect(reach).points) {
    if (std::abs(p.normal.x()) < 0.9) continue;
    ++beside;
    EXPECT_NEAR(p.initial_interference, 4e-4, 1e-9);
    EXPECT_NEAR(p.gap, 0, 1e-9);
  }
  EXPECT_GT(beside, 0);
}

TEST(ContactMemory, ASpringThatWasLetGoPushesNothingOut) {
  Scene scene = bonded_block();
  scene.laws = {{.friction = 0.6}};
  scene.detect(reach);
  auto all = outcomes(scene.contacts, Vec3::Zero(), ContactMode::stick, scene);
  for (std::size_t i = 0; i < all.size(); ++i) {
    scene.contacts.points[i].let_go = true;
    all[i].gap = -0.002;
    all[i].normal_force = 3;
  }
  scene.detector().accept(scene.contacts, all);
  scene.move(1, {0, 0, -0.002});
  ASSERT_FALSE(scene.detect(reach).points.empty());
  for (const ContactPoint& p : scene.contacts.points) {
    EXPECT_NEAR(p.gap, 0, 1e-12);
    EXPECT_NEAR(p.initial_interference, 0.002, 1e-12);
    EXPECT_FALSE(p.let_go);
    EXPECT_FALSE(p.is_new);
  }
}

TEST(ContactMemory, WhatAContactLeavesOutIsFoundHoweverSlowTheBodiesAre) {
  Scene scene = block_found_deep();
  scene.detector().accept(scene.contacts, outcomes(scene.contacts, Vec3::Zero(), ContactMode::stick, scene));
  EXPECT_NEAR(total_area(scene.detect(1e-4)), 1, 1e-4);  // but for slivers narrower than it is deep
}

TEST(ContactMemory, NothingIsFoundDeeperThanAStepCanReach) {
  // A corner that has come past beside a block is not in it, however its face's plane lies.
  Scene scene = bonded_block(0.5);
  scene.detect(reach);
  scene.detector().accept(scene.contacts, {});
  scene.move(1, {0, 0, -0.5 - 0.1 * scene.size(1)});  // a third of the largest depth
  EXPECT_TRUE(scene.detect(reach).points.empty());
}

TEST(ContactMemory, ABrokenBondLeavesResidualFriction) {
  Scene scene = bonded_block();
  scene.detect(reach);
  auto all = outcomes(scene.contacts, Vec3::Zero(), ContactMode::slip, scene);
  all[0].broke = true;
  const std::uint64_t broken = scene.contacts.points[0].key;
  scene.detector().accept(scene.contacts, all);
  scene.detect(reach);
  for (const ContactPoint& p : scene.contacts.points) {
    EXPECT_EQ(p.bonded, p.key != broken);
    EXPECT_EQ(p.friction, p.key == broken ? 0.2 : 0.6);
    EXPECT_EQ(p.cohesion > 0, p.key != broken);
  }
  // Lifted off and set down again, no bond comes back, and no friction.
  all = outcomes(scene.contacts, Vec3::Zero(), ContactMode::open, scene);
  for (ContactOutcome& o : all) o.broke = true;
  scene.detector().accept(scene.contacts, all);
  scene.detect(reach);
  for (const ContactPoint& p : scene.contacts.points) {
    EXPECT_FALSE(p.bonded);
    EXPECT_EQ(p.friction, 0.2);
  }
}

/// Accepts a step in which everything slipped by 0.25 m under a traction of 1 Pa and opened at its end.
void open_all(Scene& scene) {
  auto all = outcomes(scene.detect(reach), {1, 0, 0}, ContactMode::open, scene);
  for (ContactOutcome& o : all) o.slip = 0.25;
  scene.detector().accept(scene.contacts, all);
}

TEST(ContactMemory, OpenContactsAreForgotten) {
  Scene scene = bonded_block();
  scene.laws[0].cohesion = scene.laws[0].tensile_strength = 0;
  open_all(scene);
  ASSERT_FALSE(scene.detect(reach).points.empty());
  for (const ContactPoint& p : scene.contacts.points) {
    EXPECT_EQ(p.slip_start, 0);
    EXPECT_EQ(p.mode, ContactMode::stick) << "as its gap says";
    EXPECT_EQ(p.shear_start, Vec3::Zero());
  }
}

TEST(ContactMemory, BondedContactsAreRememberedThoughOpen) {
  Scene scene = bonded_block();
  open_all(scene);
  ASSERT_FALSE(scene.detect(reach).points.empty());
  for (const ContactPoint& p : scene.contacts.points) {
    EXPECT_EQ(p.slip_start, 0.25);
    EXPECT_EQ(p.mode, ContactMode::open);
    EXPECT_NEAR((p.shear_start - Vec3(p.area, 0, 0)).norm(), 0, 1e-12);
  }
}

TEST(ContactMemory, ShearForceTurnsWithThePlaneAndKeepsItsLength) {
  Scene scene;
  scene.add(box({0, 0, -1}, {5, 4, 0}, {2, 2, 1}));
  scene.add(box({1, 1, 0}, {2, 2, 1}, {2, 2, 2}));
  scene.detect(reach);
  scene.detector().accept(scene.contacts, outcomes(scene.contacts, {3, 0, 0}, ContactMode::stick, scene));
  const Mat3 turn = Eigen::AngleAxisd(pi / 12, Vec3::UnitY()).toRotationMatrix();  // both bodies together
  for (Vec3& p : scene.x) p = turn * p;
  scene.detect(reach);
  Vec3 force = Vec3::Zero();
  for (const ContactPoint& p : scene.contacts.points) {
    EXPECT_NEAR(p.shear_start.norm(), 3 * p.area, 1e-12);
    EXPECT_NEAR(p.shear_start.dot(p.normal), 0, 1e-12);
    force += p.shear_start;
  }
  EXPECT_LT((force - turn * Vec3(3, 0, 0)).norm(), 1e-9);
}

TEST(ContactMemory, TheMultiplierIsRememberedAsAPressure) {
  // The block slides over a mesh that does not match: parts of the area come and go, the pressure stays.
  Scene scene = bonded_block();
  scene.laws[0].cohesion = scene.laws[0].tensile_strength = 0;
  for (int step = 0; step < 50; ++step) {
    const ContactSet& contacts = scene.detect(reach);
    double carried = 0;
    for (const ContactPoint& p : contacts.points) carried += p.multiplier;
    EXPECT_NEAR(carried, step > 0 ? 300 : 0, 1e-9) << step;
    auto all = outcomes(contacts, Vec3::Zero(), ContactMode::slip, scene);
    for (std::size_t i = 0; i < all.size(); ++i) all[i].multiplier = 300 * contacts.points[i].area;
    scene.detector().accept(contacts, all);
    scene.move(1, {0.013, 0.007, 0});
  }
}

TEST(ContactMemory, AnEdgesForceGoesOnToTheNextPieceOfTheEdgeOnce) {
  Scene scene;
  const Mat3 roof = Eigen::AngleAxisd(pi / 4, Vec3::UnitX()).toRotationMatrix();
  scene.add(mapped(box({0, 0, 0}, {1, 1, 1}, {1, 1, 1}),
                   [&](const Vec3& p) { return Vec3(roof * p - Vec3(0, 0, std::sqrt(2.0))); }),
            true);
  const Mat3 edge = Eigen::AngleAxisd(-pi / 4, Vec3::UnitY()).toRotationMatrix();
  scene.add(mapped(box({0, 0, 0}, {1, 1, 1}, {1, 4, 1}),
                   [&](const Vec3& p) { return Vec3(edge * p + Vec3(0.41, -0.4, 0)); }));
  std::uint64_t before = 0;
  int changes = 0;
  for (int step = 0; step < 30; ++step) {
    const ContactSet& contacts = scene.detect(reach);
    ASSERT_EQ(contacts.points.size(), 1u);
    if (step > 0) {
      EXPECT_LT((contacts.points[0].shear_start - Vec3(0, 7, 0)).norm(), 1e-12) << step;
    }
    changes += contacts.points[0].key != before;
    before = contacts.points[0].key;
    scene.detector().accept(contacts, outcomes(contacts, {0, 7, 0}, ContactMode::slip, scene));
    scene.move(1, {0, -0.013, 0});
  }
  EXPECT_EQ(changes, 3);
}

TEST(ContactMemory, LawsMayChangeBetweenStages) {
  Scene scene = bonded_block();
  scene.detect(reach);
  scene.detector().accept(scene.contacts, outcomes(scene.contacts, {1, 0, 0}, ContactMode::stick, scene));
  scene.detector().set_laws({{.friction = 0.1, .residual_friction = 0.1, .cohesion = 1e3}});
  double cohesion = 0;
  for (const ContactPoint& p : scene.detect(reach).points) {
    EXPECT_EQ(p.friction, 0.1);
    cohesion += p.cohesion;
  }
  EXPECT_NEAR(cohesion, 1e3, 1e-8);
}

/// A force that goes on in a softer spring would hold more energy than there was.
TEST(ContactMemory, ASofterSpringHoldsNoMoreEnergy) {
  for (const double softer : {4.0, 0.25}) {
    Scene scene = bonded_block();
    scene.laws = {{.friction = 0.6, .shear_stiffness = 1e9}};
    scene.detect(reach);
    scene.detector().accept(scene.contacts, outcomes(scene.contacts, {1, 0, 0}, ContactMode::stick, scene));
    scene.detector().set_laws({{.friction = 0.6, .shear_stiffness = 1e9 / softer}});
    Vec3 force = Vec3::Zero();
    for (const ContactPoint& p : scene.detect(reach).points) force += p.shear_start;
    EXPECT_NEAR(force.x(), softer > 1 ? 1 / std::sqrt(softer) : 1, 1e-9);
  }
}

TEST(ContactMemory, ASoftBondIsFoundOverMoreThanTheReach) {
  Scene scene = bonded_block();
  scene.laws[0].normal_stiffness = 1e6;  // 5e4 Pa open it by 0.05 m
  scene.detect(1e-4);
  scene.detector().accept(scene.contacts, outcomes(scene.contacts, Vec3::Zero(), ContactMode::stick, scene));
  scene.move(1, {0, 0, 0.03});
  EXPECT_NEAR(total_area(scene.detect(1e-4)), 1, 1e-12);
}

TEST(ContactMemory, OutcomesOfAnotherSetAreRefused) {
  Scene scene = bonded_block();
  scene.detect(reach);
  EXPECT_THROW(scene.detector().accept(scene.contacts, {}), std::logic_error);
}

}  // namespace
}  // namespace talus
