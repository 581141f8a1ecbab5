#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/error.hpp"
#include "images/baseline.hpp"
#include "images/compare.hpp"
#include "images/test_scenes.hpp"
#include "render/gl/offscreen_window.hpp"
#include "render/paint/colour_map.hpp"
#include "render/scene/block_surface.hpp"
#include "render/scene/offscreen.hpp"
#include "render/scene/scene.hpp"

namespace talus {
namespace {

/// Every picture here is drawn as on a machine without a screen.
class WithoutDisplay : public testing::Environment {
  void SetUp() override {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
  }
};
const auto* const without_display = testing::AddGlobalTestEnvironment(new WithoutDisplay);

constexpr int width = 800, height = 500;

SceneSettings titled(const char* title) {
  SceneSettings settings;
  settings.title = title;
  return settings;
}

/// Two pictures of nothing are the same, too: this one shows more than the background.
void expect_blocks_in(const Image& image) {
  const BlockSystem nothing;
  Scene empty(nothing);
  EXPECT_GT(difference(image, draw_image(empty, image.width, image.height)), 0.1);
}

TEST(SceneImage, BlocksHaveTheirColours) {
  const BlockSystem slope = jointed_slope();
  Scene scene(slope, titled("Jointed slope"));
  const Image image = draw_image(scene, width, height);
  for (std::size_t b = 0; b < slope.blocks.size(); ++b)
    EXPECT_TRUE(shows_lit(image, scene.block_colour(static_cast<int>(b)))) << slope.blocks[b].name;
  EXPECT_FALSE(shows_lit(image, rgb(0xff0000)));
  expect_baseline(image);
}

/// 0 to 255.
double mean_luminance(const Image& image) {
  double sum = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3)
    sum += 0.299 * image.rgb[i] + 0.587 * image.rgb[i + 1] + 0.114 * image.rgb[i + 2];
  return 3 * sum / static_cast<double>(image.rgb.size());
}

/// How much darker than without its lines a cube of so many cells a side is drawn, of what black would take.
double taken_by_mesh_lines(int cells) {
  BlockSystem system;
  system.blocks = {box("B", {0, 0, 0}, {1, 1, 1}, cells, BodyKind::tetrahedra)};
  SceneSettings settings;
  settings.legend = settings.triad = settings.scale_bar = false;
  Scene scene(system, settings);
  const double plain = mean_luminance(draw_image(scene, width, height));
  settings.edges = Edges::mesh;
  scene.set_settings(settings);
  return 1 - mean_luminance(draw_image(scene, width, height)) / plain;
}

/// The cube fills about a third of the picture.
TEST(SceneImage, LinesOfAFineMeshDoNotBlackenTheRock) {
  const double coarse = taken_by_mesh_lines(6), fine = taken_by_mesh_lines(30), finest = taken_by_mesh_lines(90);
  EXPECT_GT(coarse, 0.002) << "lines that are far apart are seen";
  EXPECT_LT(fine, 0.02);
  EXPECT_LT(finest, 0.02);
}

TEST(SceneImage, DisplacementWithLegend) {
  const BlockSystem slope = jointed_slope();
  SceneSettings settings = titled("Jointed slope");
  settings.field = field_named("displacement");
  Scene scene(slope, settings);
  scene.set_stage_names({"slide"});
  const auto frame = slid(slope, 14, 45);
  scene.include_in_view(*frame);
  scene.set_frame(frame);
  EXPECT_EQ(scene.shown_range(), (ValueRange{0, 20}));
  const Image image = draw_image(scene, width, height);
  for (const double t : {0.02, 0.25, 0.5, 0.75, 0.98}) EXPECT_GT(count_of(image, batlow().at(t)), 10) << t;
  EXPECT_TRUE(shows_lit(image, colours(Theme::light).rock));  // fixed rock is not coloured by the field
  expect_baseline(image);
}

TEST(SceneImage, OnlyFacesWhoseValuesLieInARangeAndArrowsOfVelocity) {
  const BlockSystem slope = jointed_slope();
  SceneSettings settings = titled("Jointed slope");
  settings.field = field_named("displacement");
  settings.only = ValueRange{4, 12};
  settings.arrows = Arrows::velocity;
  Scene scene(slope, settings);
  scene.set_frame(slid(slope, 14, 45));
  const Image image = draw_image(scene, width, height);
  for (const double t : {0.05, 0.95}) EXPECT_LT(count_of(image, batlow().at(t)), 40) << t;  // but for the legend
  EXPECT_GT(count_of(image, colours(Theme::light).pick), 20);
  expect_baseline(image);
}

TEST(SceneImage, CrossesOfPrincipalStressPointInwardsWhereRockIsPressed) {
  const BlockSystem slope = jointed_slope();
  SceneSettings settings = titled("Principal stresses");
  settings.arrows = Arrows::principal_stress;
  settings.edges = Edges::none;
  Scene scene(slope, settings);
  const auto frame = slid(slope, 0, 0);
  for (std::size_t i = 0; i < frame->stress.size(); ++i) frame->stress[i][0] = -0.5 * frame->stress[i][2];
  scene.set_frame(frame);
  const Image image = draw_image(scene, width, height);
  EXPECT_GT(count_of(image, colours(Theme::light).pick), 100);
  expect_baseline(image);
}

TEST(SceneImage, SignedStressInTheDarkWithMeshAndSelection) {
  const BlockSystem slope = jointed_slope();
  SceneSettings settings = titled("Vertical stress");
  settings.theme = Theme::dark;
  settings.field = field_named("stress.zz");
  settings.edges = Edges::mesh;
  Scene scene(slope, settings);
  scene.set_frame(slid(slope, 0, 0));
  scene.set_selected({5});
  scene.set_hovered(8);
  const Image image = draw_image(scene, width, height);
  EXPECT_GT(count_of(image, colours(Theme::dark).pick), 50);
  EXPECT_GT(count_of(image, vik().at(0.5)), 4);
  EXPECT_DOUBLE_EQ(scene.shown_range()->low, -scene.shown_range()->high);
  expect_baseline(image);
}

TEST(SceneImage, FrontParallelWithContacts) {
  const BlockSystem slope = jointed_slope();
  SceneSettings settings;
  settings.contacts = true;
  settings.parallel_projection = true;
  settings.deformation_scale = 2;
  Scene scene(slope, settings);
  scene.look(View::front);
  scene.set_frame(slid(slope, 3, 2.5));
  const Image image = draw_image(scene, width, height);
  constexpr double a_few_dots = 2e-5;
  EXPECT_TRUE(shows_lit(image, rgb(0x0068a8), a_few_dots));  // stick
  EXPECT_TRUE(shows_lit(image, rgb(0xd2580a), a_few_dots));  // slip
  expect_baseline(image);
}

/// A run that has trouble to converge at B6 on the slope, and between B2 and B3.
std::vector<ConvergenceTrouble> two_troubles(const BlockSystem& slope) {
  std::vector<ConvergenceTrouble> troubles(2);
  troubles[0].blocks = {"slope", "B6"};
  troubles[0].rest_position = slope.blocks[7].mesh.nodes.front();
  troubles[1].blocks = {"B2", "B3"};
  troubles[1].rest_position = slope.blocks[4].mesh.nodes.back();
  return troubles;
}

TEST(SceneImage, PlacesOfConvergenceTroubleAreMarked) {
  const BlockSystem slope = jointed_slope();
  SceneSettings settings = titled("Jointed slope");
  Scene scene(slope, settings);
  scene.set_frame(slid(slope, 3, 2.5));
  const Image plain = draw_image(scene, width, height);
  scene.set_troubles(two_troubles(slope));
  const Image marked = draw_image(scene, width, height);
  EXPECT_GT(count_of(marked, colours(Theme::light).warn), count_of(plain, colours(Theme::light).warn) + 200);
  expect_baseline(marked);
  settings.troubles = false;
  scene.set_settings(settings);
  EXPECT_EQ(difference(plain, draw_image(scene, width, height)), 0);
}

TEST(SceneImage, ATroubleIsLookedAtAndItsMarkGoesWithItsBlock) {
  const BlockSystem slope = jointed_slope();
  SceneSettings settings;
  settings.theme = Theme::dark;
  settings.field = field_named("displacement");
  Scene scene(slope, settings);
  const std::vector<ConvergenceTrouble> troubles = two_troubles(slope);
  const Vec3 before = scene.pose_at(troubles[0]).focal_point;
  EXPECT_LT((before - troubles[0].rest_position).norm(), 1e-9);
  const auto frame = slid(slope, 14, 45);
  scene.set_frame(frame);
  const CameraPose look = scene.pose(), near = scene.pose_at(troubles[0]);
  std::size_t node = 0;
  for (std::size_t b = 0; b < 7; ++b) node += slope.blocks[b].mesh.nodes.size();
  EXPECT_LT((near.focal_point - before - frame->displacement[node]).norm(), 1e-9);
  EXPECT_LT(
      (near.focal_point - near.position).normalized().cross((look.focal_point - look.position).normalized()).norm(),
      1e-9);
  EXPECT_LT((near.focal_point - near.position).norm(), (look.focal_point - look.position).norm());
  scene.set_troubles(troubles);
  scene.set_pose(near);
  expect_baseline(draw_image(scene, width, height));
}

/// Edges of the slope run below the blocks on it, which fill this part of the picture.
TEST(SceneImage, EdgesOfWhatIsSelectedAreNotSeenThroughWhatIsBefore) {
  const BlockSystem slope = jointed_slope();
  Scene scene(slope, {});
  scene.set_frame(slid(slope, 14, 45));
  scene.set_pose(scene.pose_at(two_troubles(slope)[0]));
  const Image without = draw_image(scene, width, height);
  scene.set_selected({0});
  const Image with = draw_image(scene, width, height);
  const auto differ = [&](int left, int right, int top, int bottom) {
    int count = 0;
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x) {
        const std::size_t i = 3 * (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x));
        count += std::abs(with.rgb[i] - without.rgb[i]) > 40 ? 1 : 0;
      }
    return count;
  };
  EXPECT_EQ(differ(300, 380, 250, 310), 0);
  EXPECT_GT(differ(0, width, 0, height), 50) << "its other edges are seen";
}

/// Cut open along its length, the slope shows the blocks' and its own inside, and what is before the plane is gone.
TEST(SceneImage, ASectionShowsTheFieldInsideTheBlocks) {
  const BlockSystem slope = jointed_slope();
  SceneSettings settings;
  settings.field = field_named("displacement");
  Scene scene(slope, settings);
  scene.set_frame(slid(slope, 3, 2.5));
  OffscreenView view(scene, width, height);
  const Image whole = view.draw();
  const Eigen::AlignedBox3d box = bounds(slope);
  settings.section = SectionPlane{box.center(), -Vec3::UnitY()};
  scene.set_settings(settings);
  const Image cut = view.draw();
  EXPECT_GT(difference(whole, cut), 0.1);
  EXPECT_GT(count_of(cut, colours(Theme::light).rock), 5000) << "the inside of fixed rock, without shade";
  for (int x = 0; x < 2 * width; x += 40)
    for (int y = 0; y < 2 * height; y += 40)
      if (const auto pick = scene.pick(x, y)) {
        EXPECT_GT(pick->position.y(), box.center().y() - 1e-6);
      }
  expect_baseline(cut);
}

TEST(SceneImage, SmallTopViewWithHiddenBlocks) {
  const BlockSystem boxes = two_boxes();
  Scene scene(boxes);
  scene.look(View::top);
  scene.set_hidden({1});
  const Image image = draw_image(scene, 320, 240);
  EXPECT_FALSE(shows_lit(image, scene.block_colour(1)));
  EXPECT_TRUE(shows_lit(image, scene.block_colour(2)));
  expect_baseline(image);
}

TEST(SceneImage, CoarseDrawingForDragging) {
  const BlockSystem slope = jointed_slope();
  SceneSettings settings;
  settings.fine = false;
  Scene scene(slope, settings);
  scene.look(135, 20);
  expect_baseline(draw_image(scene, width, height));
}

TEST(SceneImage, IsTheSameTwice) {
  const BlockSystem slope = jointed_slope();
  const auto draw = [&] {
    Scene scene(slope);
    return draw_image(scene, 320, 240);
  };
  const Image first = draw();
  expect_blocks_in(first);
  EXPECT_EQ(draw().rgb, first.rgb);
}

TEST(SceneImage, IsTheSameByOsMesaAndByEgl) {
  const BlockSystem boxes = two_boxes();
  const auto draw = [&](OffscreenBackend backend) {
    Scene scene(boxes);
    OffscreenWindow window(320, 240, 1, backend);
    window.add(*scene.renderer());
    scene.fit();
    Image image = window.draw();
    window.remove(*scene.renderer());
    return image;
  };
  const Image by_osmesa = draw(OffscreenBackend::osmesa);
  expect_blocks_in(by_osmesa);
  const Image by_egl = draw(OffscreenBackend::egl);
  EXPECT_EQ(difference(by_osmesa, by_egl), 0);
}

TEST(SceneImage, SurvivesANewContextAndASecondWindow) {
  const BlockSystem boxes = two_boxes();
  Scene scene(boxes);
  const Image before = draw_image(scene, 320, 240);
  expect_blocks_in(before);
  {  // as when a floating view is docked: the window stays, its context goes and another one comes
    const auto first = make_offscreen_context(), second = make_offscreen_context();
    vtkNew<RenderWindow> window;
    window->AddRenderer(scene.renderer());
    for (const auto* context : {&first, &second}) {
      window->set_context(**context);
      window->SetSize(100, 100);
      window->Render();
      window->release_context();
    }
    window->RemoveRenderer(scene.renderer());
  }
  EXPECT_EQ(draw_image(scene, 320, 240).rgb, before.rgb);
}

TEST(SceneImage, FarFromTheOriginLooksTheSame) {
  const BlockSystem near = two_boxes();
  BlockSystem far = near;
  for (Block& block : far.blocks)
    for (Vec3& node : block.mesh.nodes) node += Vec3(512307.4, 3214880.1, 1214.6);
  Scene near_scene(near), far_scene(far);
  const Image near_image = draw_image(near_scene, 320, 240);
  expect_blocks_in(near_image);
  EXPECT_EQ(difference(near_image, draw_image(far_scene, 320, 240)), 0);
}

TEST(SceneImage, LegendAndRockDoNotOverlap) {
  const BlockSystem slope = jointed_slope();
  SceneSettings settings;
  settings.field = field_named("stress.min_principal");
  Scene scene(slope, settings);
  scene.set_frame(slid(slope, 5, 1));
  for (const auto& [w, h] : {std::pair{800, 500}, {500, 500}, {1200, 400}, {400, 600}}) {
    OffscreenView view(scene, w, h);
    const Image image = view.draw();
    constexpr int drawn_for_each = 2;
    int card = 0, rock_under_card = 0;
    for (int y = 0; y < h; y += 5)
      for (int x = 0; x < w / 3; x += 5) {
        const Rgb seen = image.at(x, y);
        if (std::min({seen.red, seen.green, seen.blue}) < 252) continue;  // only the card is as white as that
        ++card;
        rock_under_card += scene.pick(x * drawn_for_each, y * drawn_for_each).has_value();
      }
    EXPECT_GT(card, 50) << w << 'x' << h;
    EXPECT_EQ(rock_under_card, 0) << w << 'x' << h;
  }
}

TEST(SceneImage, KeepsTheWholeRunInView) {
  const BlockSystem slope = jointed_slope();
  Scene scene(slope);
  const auto last = slid(slope, 60, 100);
  scene.include_in_view(*last);
  OffscreenView view(scene, 400, 300);
  view.hold_camera();
  const CameraPose pose = scene.pose();
  const Image first = view.draw();
  scene.set_frame(last);
  const Image moved = view.draw();
  EXPECT_TRUE(scene.pose().position.isApprox(pose.position));
  EXPECT_GT(difference(first, moved), 0.01);
  // No block colour touches the picture's edge.
  for (int x = 0; x < moved.width; ++x)
    for (const int y : {0, moved.height - 1}) {
      const Rgb c = moved.at(x, y);
      EXPECT_LT(std::max({c.red, c.green, c.blue}) - std::min({c.red, c.green, c.blue}), 16);
    }
}

TEST(Picking, FindsBlockPlaceNodeAndValue) {
  const BlockSystem boxes = two_boxes();
  SceneSettings settings;
  settings.field = field_named("displacement.x");
  settings.parallel_projection = true;
  settings.legend = settings.triad = settings.scale_bar = settings.time_stamp = false;
  Scene scene(boxes, settings);
  EXPECT_FALSE(scene.pick(10, 10).has_value());  // in no window yet
  auto frame = std::make_shared<Frame>();
  std::size_t tetrahedra = 0;
  for (const Block& block : boxes.blocks) {
    for (const Vec3& node : block.mesh.nodes) frame->displacement.push_back({0.1 * node.z(), 0, 0});
    tetrahedra += block.mesh.tetrahedra.size();
  }
  frame->velocity.resize(frame->displacement.size(), Vec3::Zero());
  frame->stress.resize(tetrahedra, Voigt::Zero());
  scene.set_frame(frame);
  scene.look(View::front);
  OffscreenView view(scene, 400, 300);
  view.draw();
  const auto hit = scene.pick(400, 300);  // the middle of what is drawn at twice the size
  ASSERT_TRUE(hit.has_value());
  EXPECT_TRUE(hit->block == 1 || hit->block == 2);
  EXPECT_NEAR(hit->position.y(), 0, 1e-6);
  EXPECT_NEAR(hit->position.x(), 1.0, 0.15);
  ASSERT_TRUE(hit->value.has_value());
  EXPECT_NEAR(*hit->value, 0.1 * hit->position.z(), 1e-9);
  const int first_node = static_cast<int>(boxes.blocks[0].mesh.nodes.size());
  EXPECT_GE(hit->node, first_node);
  EXPECT_GE(hit->tetrahedron, static_cast<int>(boxes.blocks[0].mesh.tetrahedra.size()));
  EXPECT_FALSE(scene.pick(2, 2).has_value());
  scene.set_hidden({0, 1, 2});
  EXPECT_FALSE(scene.pick(400, 300).has_value());
}

TEST(SceneErrors, AreToldApart) {
  const BlockSystem boxes = two_boxes();
  Scene scene(boxes);
  EXPECT_THROW(scene.set_frame(std::make_shared<Frame>()), std::invalid_argument);
  EXPECT_THROW(draw_image(scene, 8193, 100), InputError);
  EXPECT_THROW(draw_image(scene, 0, 100), InputError);
  EXPECT_THROW(render_png(scene, "/nowhere/at/all.png", 64, 64), InputError);
}

TEST(EmptyScene, IsABackground) {
  const BlockSystem nothing;
  Scene scene(nothing);
  const Image image = draw_image(scene, 200, 150);
  ASSERT_EQ(image.width, 200);
  ASSERT_EQ(image.height, 150);
  const auto expect_near = [](Rgb seen, Rgb wanted, const char* where) {
    EXPECT_NEAR(seen.red, wanted.red, 3) << where;
    EXPECT_NEAR(seen.green, wanted.green, 3) << where;
    EXPECT_NEAR(seen.blue, wanted.blue, 3) << where;
  };
  for (const int x : {0, 100, 199}) {
    expect_near(image.at(x, 0), colours(Theme::light).view_top, "top");
    expect_near(image.at(x, 149), colours(Theme::light).view_bottom, "bottom");
  }
}

}  // namespace
}  // namespace talus
