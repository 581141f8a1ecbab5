#include <gtest/gtest.h>

#include <algorithm>

#include "base/units.hpp"
#include "contact/history/contact_memory.hpp"
#include "unit/contact/blocks.hpp"

/// Other tolerances than the usual ones reach whoever goes by them.
namespace talus {
namespace {

using testing::box;
using testing::mapped;
using testing::reach;
using testing::Scene;
using testing::total_area;

/// A cube, tilted by `degrees` about its lower edge along y, `gap` above a slab.
Scene cube_over_slab(double degrees, double gap, const ContactTolerances& tolerances) {
  Scene scene;
  scene.settings.tolerances = tolerances;
  scene.laws = {{.friction = 0.6, .cohesion = 2e5}};
  scene.add(box({-2, -2, -1}, {2, 2, 0}), true);
  const Mat3 turn = Eigen::AngleAxisd(radians(-degrees), Vec3::UnitY()).toRotationMatrix();
  scene.add(mapped(box({0, 0, 0}, {1, 1, 1}), [&](const Vec3& p) { return Vec3(turn * p + Vec3(0, 0, gap)); }));
  return scene;
}

TEST(Tolerances, TheFaceFaceAngleDecidesWhetherATiltedFaceTouches) {
  EXPECT_GT(total_area(cube_over_slab(2, 0, {}).detect(0.1)), 0.9);
  EXPECT_EQ(total_area(cube_over_slab(2, 0, {.face_face_angle = 1.5}).detect(0.1)), 0);
  EXPECT_EQ(total_area(cube_over_slab(4, 0, {}).detect(0.1)), 0);
  EXPECT_GT(total_area(cube_over_slab(4, 0, {.face_face_angle = 6}).detect(0.1)), 0.9);
}

TEST(Tolerances, TheBondedGapDecidesWhatIsOneJoint) {
  for (const bool wide : {false, true}) {
    Scene scene = cube_over_slab(0, 1.5e-3, {.bonded_gap = wide ? 2e-3 : 1e-3});
    ASSERT_FALSE(scene.detect(reach).points.empty());
    for (const ContactPoint& p : scene.contacts.points) EXPECT_EQ(p.bonded, wide);
  }
}

TEST(Tolerances, TheLargestDepthDecidesWhatLiesInABody) {
  EXPECT_GT(total_area(cube_over_slab(0, -0.2, {}).detect(reach)), 0.9);
  EXPECT_EQ(total_area(cube_over_slab(0, -0.2, {.largest_depth = 0.15}).detect(reach)), 0);
}

TEST(Tolerances, TheTransferDistanceDecidesHowFarAForceGoes) {
  ContactPoint before;
  before.key = 1;
  before.bodies[1] = 1;
  before.normal = Vec3::UnitZ();
  before.size = 1;
  before.mode = ContactMode::stick;
  FoundPoint after{};
  after.key = 2;
  after.family = 8;
  after.bodies = {0, 1};
  after.normal = Vec3::UnitZ();
  after.position = Vec3(0.3, 0, 0);
  for (const double within : {0.2, 0.4}) {
    ContactMemory memory(2, false, {.transfer_across_features = within});
    const std::uint64_t family = 7;
    const ContactOutcome outcome{.shear_force = Vec3(5, 0, 0)};
    ContactSet contacts;
    contacts.points.push_back(before);
    contacts.sort_out();
    memory.accept(contacts, {&family, 1}, {&outcome, 1});
    memory.transfer({&after, 1});
    const auto transferred = memory.transferred_to(0, 1);
    ASSERT_EQ(transferred.has_value(), within > 0.3);
    if (transferred) {
      EXPECT_EQ(transferred->shear, outcome.shear_force);
    }
  }
}

TEST(Tolerances, TheMemoryOfADetectorHasThem) {
  for (const double least : {1e-6, 2.0}) {  // of the shear force that is left in a new plane; 2: never enough
    Scene scene = cube_over_slab(0, 0, {.least_turned_shear = least});
    std::vector<ContactOutcome> outcomes(scene.detect(reach).points.size(), {.shear_force = Vec3::UnitX()});
    scene.detector().accept(scene.contacts, outcomes);
    const Mat3 turn = Eigen::AngleAxisd(radians(10), Vec3::UnitY()).toRotationMatrix();  // both bodies together
    for (Vec3& p : scene.x) p = turn * p;
    ASSERT_FALSE(scene.detect(reach).points.empty());
    for (const ContactPoint& p : scene.contacts.points) EXPECT_NEAR(p.shear_start.norm(), least < 1 ? 1 : 0, 1e-9);
  }
}

}  // namespace
}  // namespace talus
