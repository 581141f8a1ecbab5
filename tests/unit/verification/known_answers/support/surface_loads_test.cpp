#include "verification/known_answers/support/surface_loads.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

using namespace talus;

namespace {

Block slab() {
  CaseScene scene;
  scene.add_material({.name = "rock", .density = 2000, .young = 1e9, .poisson = 0.2});
  scene.add_block("slab", box_mesh({0, 0, 0}, {2, 3, 1}, 3, 2, 2), BodyKind::tetrahedra);
  return scene.system.blocks.front();
}

}  // namespace

TEST(SurfaceLoads, CarryThePressureOfAFaceAtItsMiddle) {
  const auto loads =
      surface_loads(slab(), [](const Vec3&, const Vec3& normal) { return Vec3(0, 0, normal.z() > 0.5 ? -7.0 : 0.0); });
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (const PointLoad& load : loads) {
    EXPECT_EQ(load.at.z(), 1);
    force += load.force;
    moment += load.at.cross(load.force);
  }
  EXPECT_EQ(loads.size(), 12u);
  EXPECT_LT((force - Vec3(0, 0, -42)).norm(), 1e-12);
  EXPECT_LT((moment - Vec3(1, 1.5, 1).cross(Vec3(0, 0, -42))).norm(), 1e-12);
}

TEST(SurfaceLoads, OfASymmetricStressAreInEquilibrium) {
  Mat3 stress;
  stress << 3, 1, 2, 1, -4, 5, 2, 5, 6;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (const PointLoad& load :
       surface_loads(slab(), [&](const Vec3&, const Vec3& normal) { return Vec3(stress * normal); })) {
    force += load.force;
    moment += load.at.cross(load.force);
  }
  EXPECT_LT(force.norm(), 1e-12);
  EXPECT_LT(moment.norm(), 1e-12);
}
