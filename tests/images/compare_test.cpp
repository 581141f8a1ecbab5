#include "images/compare.hpp"

#include <gtest/gtest.h>

#include "images/test_scenes.hpp"
#include "render/scene/offscreen.hpp"
#include "render/scene/scene.hpp"

namespace talus {
namespace {

// The comparison itself: it must forgive rounding and must not forgive a block in another place.
TEST(Comparison, ForgivesNoiseAndNothingElse) {
  const BlockSystem boxes = two_boxes();
  Scene scene(boxes);
  const Image image = draw_image(scene, 320, 240);
  Image noisy = image;
  for (std::size_t i = 0; i < noisy.rgb.size(); i += 7) noisy.rgb[i] = static_cast<std::uint8_t>(noisy.rgb[i] ^ 3);
  EXPECT_EQ(difference(image, noisy), 0);

  BlockSystem moved = boxes;
  for (Vec3& node : moved.blocks[2].mesh.nodes) node.x() += 0.1;
  Scene moved_scene(moved);
  moved_scene.set_pose(scene.pose());
  EXPECT_GT(difference(image, draw_image(moved_scene, 320, 240)), 0);

  SceneSettings without_legend;
  without_legend.scale_bar = false;
  scene.set_settings(without_legend);
  EXPECT_GT(difference(image, draw_image(scene, 320, 240)), 0);
}

}  // namespace
}  // namespace talus
