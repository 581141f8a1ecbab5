#include <gtest/gtest.h>

#include "images/baseline.hpp"
#include "images/compare.hpp"
#include "images/test_scenes.hpp"
#include "orientation/cut_moves.hpp"
#include "render/scene/offscreen.hpp"

namespace talus {
namespace {

constexpr int joints_width = 640, joints_height = 400;

/// A bench in front of a wall, as one piece of rock.
BlockSystem bench() {
  BlockSystem rock;
  const std::array<Vec3, 8> corners{Vec3(0, 0, 0),  Vec3(30, 0, 0),  Vec3(0, 20, 0),  Vec3(30, 20, 0),
                                    Vec3(8, 0, 15), Vec3(30, 0, 15), Vec3(8, 20, 15), Vec3(30, 20, 15)};
  rock.blocks = {hexahedron("bench", corners, 2, BodyKind::rigid)};
  return rock;
}

void add(JointFace& face, const BlockSystem& rock, const Cut& cut) {
  std::vector<std::array<int, 3>> triangles;
  for (const SurfaceTriangle& t : rock.blocks[0].surface) triangles.push_back(t.nodes);
  const PlaneSection section({rock.blocks[0].mesh.nodes, triangles}, cut.through, normal_of(cut));
  for (const FlatTriangle& t : section.triangles()) face.triangles.push_back(t);
  for (const Edge& edge : section.outline()) face.outline.push_back(edge);
}

/// Four planes that dip out of the bench's face, and two steep ones across.
std::shared_ptr<std::vector<JointFace>> joints(const BlockSystem& rock) {
  JointFace bedding{0, 0, {}, {}}, cross{1, 1, {}, {}};
  Cut cut;
  cut.dip = 35;
  cut.dip_direction = 270;
  for (const double x : {10.0, 16.0, 22.0, 28.0}) {
    cut.through = {x, 10, 6};
    add(bedding, rock, cut);
  }
  cut.dip = 85;
  cut.dip_direction = 10;
  for (const double y : {7.0, 14.0}) {
    cut.through = {15, y, 8};
    add(cross, rock, cut);
  }
  return std::make_shared<std::vector<JointFace>>(std::vector{bedding, cross});
}

Image drawn(Theme theme, std::vector<int> chosen) {
  const BlockSystem rock = bench();
  SceneSettings settings;
  settings.theme = theme;
  settings.rock_opacity = 0.22;
  Scene scene(rock, settings);
  scene.set_joints(joints(rock), std::move(chosen));
  return draw_image(scene, joints_width, joints_height);
}

TEST(JointsImage, LieInTranslucentRock) {
  const Image plain = drawn(Theme::light, {});
  expect_baseline(plain);
  EXPECT_GT(difference(plain, drawn(Theme::light, {0})), 0);
}

TEST(JointsImage, TheChosenOneIsStrongerInTheDark) { expect_baseline(drawn(Theme::dark, {1})); }

TEST(JointsImage, AreDrawnAnewWhenTheyChange) {
  const BlockSystem rock = bench();
  SceneSettings settings;
  Scene scene(rock, settings);
  OffscreenView view(scene, joints_width, joints_height);
  view.draw();  // as a window shows it before, without joints and with shaded corners
  settings.rock_opacity = 0.22;
  settings.fine = false;
  scene.set_settings(settings);
  const auto few = joints(rock);
  few->pop_back();
  scene.set_joints(few, {0});
  view.draw();
  scene.set_joints(joints(rock), {0});
  const Image changed = view.draw();
  expect_baseline(changed);
  Scene fresh(rock, settings);
  fresh.set_joints(joints(rock), {0});
  EXPECT_EQ(difference(changed, draw_image(fresh, joints_width, joints_height)), 0);
}

TEST(JointsImage, TheFirstUnderAPixelIsFound) {
  const BlockSystem rock = bench();
  SceneSettings settings;
  settings.parallel_projection = true;
  settings.legend = settings.triad = settings.scale_bar = false;
  Scene scene(rock, settings);
  scene.set_joints(joints(rock), {});
  scene.look(View::front);  // looks north: the plane at y = 7 is met before the one at 14
  OffscreenView view(scene, 400, 300);
  view.draw();
  const auto pixel = scene.pixel_of({29, 0, 14});
  ASSERT_TRUE(pixel.has_value());
  EXPECT_EQ(scene.joint_at((*pixel)[0], (*pixel)[1]), 1);
  EXPECT_FALSE(scene.joint_at(2, 2).has_value());
}

}  // namespace
}  // namespace talus
