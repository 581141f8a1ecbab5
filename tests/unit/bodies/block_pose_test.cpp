#include "bodies/block_pose.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/small_scenes.hpp"

namespace talus {
namespace {

struct TwoBoxes {
  TwoBoxes() {
    project.materials = {{"rock", 2600, 5e9, 0.24}};
    system.blocks = {test::box_block("ground", Vec3(0, 0, -1), Vec3(4, 4, 0), BodyKind::fixed),
                     test::box_block("B", far, far + Vec3(1, 2, 3))};
  }
  const Vec3 far{4e5, 5e6, 300};  // coordinates as of a country's grid
  Project project;
  BlockSystem system;
};

TEST(PoseFit, KnowsCentroidVolumeAndSpreadOfABox) {
  const TwoBoxes scene;
  const PoseFit fit(scene.system);
  const BodySet bodies(scene.project, scene.system);
  EXPECT_LT((fit.poses(bodies)[1].centroid - scene.far - Vec3(0.5, 1, 1.5)).norm(), 1e-8);
  EXPECT_LT((fit.poses(bodies)[1].rotation - Mat3::Identity()).norm(), 1e-8);
  EXPECT_NEAR(fit.volume(1), 6, 1e-8);
  EXPECT_LT((fit.spread(1) - Mat3(Vec3(1. / 12, 4. / 12, 9. / 12).asDiagonal())).norm(), 1e-8);
}

TEST(PoseFit, FollowsALargeRotationAndOverlooksAUniformStretch) {
  const TwoBoxes scene;
  BodySet bodies(scene.project, scene.system);
  const PoseFit fit(scene.system);
  const Mat3 turn = Eigen::AngleAxisd(2.5, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  const Vec3 centre = fit.poses(bodies)[1].centroid, moved(3, -4, 5);
  for (int n = 8; n < 16; ++n)
    bodies.nodes.position[n] = centre + moved + 1.001 * turn * (bodies.nodes.reference[n] - centre);
  const BlockPose pose = fit.poses(bodies)[1];
  EXPECT_LT((pose.centroid - centre - moved).norm(), 1e-8);
  EXPECT_LT((pose.rotation - turn).norm(), 1e-8);
}

TEST(PoseFit, AFixedBlockGoesWithItsBase) {
  const TwoBoxes scene;
  BodySet bodies(scene.project, scene.system);
  for (int n = 0; n < 8; ++n) bodies.nodes.position[n] += Vec3(0.1, 0, 0);
  EXPECT_LT((PoseFit(scene.system).poses(bodies)[0].centroid - Vec3(2.1, 2, -0.5)).norm(), 1e-12);
}

}  // namespace
}  // namespace talus
