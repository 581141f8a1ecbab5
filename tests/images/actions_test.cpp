// Loads, supports, velocities, stress in situ and monitors in the picture.
#include <gtest/gtest.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <vector>

#include "images/baseline.hpp"
#include "images/compare.hpp"
#include "images/test_scenes.hpp"
#include "model/project.hpp"
#include "render/gl/offscreen_window.hpp"
#include "render/scene/offscreen.hpp"
#include "render/scene/scene.hpp"

namespace talus {
namespace {

using Kind = ActionGlyph::Kind;
constexpr int picture_width = 800, picture_height = 500;

/// On the slope of test_scenes: 250 and 100 kN, a held point, one that may slip along y, a moved one, a monitor.
Project acted_on(const BlockSystem& slope) {
  Project project;
  const auto& top = [&](int block) -> const Vec3& {
    return slope.blocks[static_cast<std::size_t>(block)].mesh.nodes.back();
  };
  project.loads = {{.block = "B4", .at = top(5), .force = {0, 0, -250e3}},
                   {.block = "B8", .at = top(9), .force = {-100e3, 0, 0}}};
  project.constraints = {{.block = "toe", .at = Vec3(-20, 4, 0)},
                         {.block = "toe", .at = Vec3(-20, 12, 0), .displacement = {0, std::nullopt, 0}},
                         {.block = "toe", .at = Vec3(-20, 20, 0), .displacement = {0.1, 0, 0}}};
  project.monitors = {{.name = "P1", .block = "B1", .at = slope.blocks[2].mesh.nodes.back()}};
  return project;
}

/// Blocks looked at from the front, without perspective, and what is drawn where for what acts on them.
class GlyphsInView {
 public:
  GlyphsInView(const BlockSystem& blocks, const Project& project) : scene(blocks, without_perspective()) {
    window_.add(*scene.renderer());
    scene.look(View::front);
    scene.set_actions(action_glyphs(project, blocks));
  }
  ~GlyphsInView() { window_.remove(*scene.renderer()); }
  GlyphsInView(const GlyphsInView&) = delete;
  GlyphsInView& operator=(const GlyphsInView&) = delete;

  /// Pixels that show glyphs, every second one along both sides.
  struct Found {
    int x, y;
    Kind kind;
  };
  std::vector<Found> found() {
    std::vector<Found> pixels;
    for (int y = 0; y < picture_height; y += 2)
      for (int x = 0; x < picture_width; x += 2)
        if (const auto glyph = scene.action_at(x, y)) pixels.push_back({x, y, glyph->kind});
    return pixels;
  }

  Scene scene;

 private:
  static SceneSettings without_perspective() {
    SceneSettings settings;
    settings.parallel_projection = true;
    return settings;
  }
  OffscreenWindow window_{picture_width, picture_height, 1};
};

TEST(ActionImage, LoadsSupportsAndMonitors) {
  const BlockSystem slope = jointed_slope();
  Scene scene(slope);
  const Image plain = draw_image(scene, picture_width, picture_height);
  auto glyphs = action_glyphs(acted_on(slope), slope);
  glyphs[1].selected = true;
  scene.set_actions(glyphs);
  const Image image = draw_image(scene, picture_width, picture_height);
  EXPECT_GT(difference(plain, image), 0.01);
  EXPECT_TRUE(shows_lit(image, curve_palette(Theme::light)[4]));    // loads
  EXPECT_TRUE(shows_lit(image, curve_palette(Theme::light)[2]));    // supports
  EXPECT_TRUE(shows_lit(image, colours(Theme::light).pick, 2e-5));  // the one that is selected
  expect_baseline(image);
  SceneSettings without = scene.settings();
  without.actions = false;
  scene.set_settings(without);
  EXPECT_EQ(difference(plain, draw_image(scene, picture_width, picture_height)), 0);
}

TEST(ActionImage, DarkStressInSituAndVelocities) {
  const BlockSystem slope = jointed_slope();
  SceneSettings settings;
  settings.theme = Theme::dark;
  Scene scene(slope, settings);
  Project project;
  Voigt pressed;
  pressed << -2e6, -1e6, 0.5e6, 0, 0, 0;
  Voigt gradient;
  gradient << 0.05e6, 0.05e6, 0, 0, 0, 0;
  project.in_situ = {{.blocks = {}, .stress = pressed, .gradient = gradient}};
  project.velocities = {{.block = "B4", .linear = {-2, 0, -1}},
                        {.block = "B9", .linear = {0, 0, 0}, .angular = {0, 1, 0}}};
  scene.set_actions(action_glyphs(project, slope));
  expect_baseline(draw_image(scene, picture_width, picture_height));
}

/// Joint sets, what acts and blocks take their colours from three palettes; an olive arrow on an olive block has a rim.
TEST(ActionImage, HasARimThatLeavesItsColourToBeSeen) {
  constexpr int width = 400, height = 250;
  const BlockSystem boxes = two_boxes();
  const auto plate = static_cast<int>(boxes.blocks.size()) - 1;
  const Vec3 middle(1, 0.5, 0.5);
  std::vector<ActionGlyph> glyphs{
      {.kind = Kind::load, .block = plate, .at = middle, .arrow = {0, 1, 0}, .label = {}},
      {.kind = Kind::support, .block = plate, .at = middle, .held = {true, false, false}, .label = {}},
      {.kind = Kind::velocity, .block = plate, .at = middle, .arrow = {0, 1, 0}, .label = {}},
      {.kind = Kind::stress, .block = plate, .at = middle, .label = {}},
      {.kind = Kind::monitor, .block = plate, .at = middle, .label = {}}};
  glyphs[3].cross[0] = {.direction = {0, 0, 1}, .value = -1e6};
  constexpr std::array<std::size_t, 5> colour{4, 2, 5, 1, 0};
  const auto grey = std::make_shared<BlockColours>();
  grey->colours.assign(boxes.blocks.size(), colours(Theme::light).rock);
  for (const Theme theme : {Theme::light, Theme::dark})
    for (std::size_t i = 0; i < glyphs.size(); ++i) {
      SCOPED_TRACE(testing::Message() << "kind " << i << (theme == Theme::dark ? ", dark" : ", light"));
      const Rgb own = curve_palette(theme).at(colour.at(i)), rim = colours(theme).surface;
      SceneSettings settings;
      settings.theme = theme;
      settings.block_colours = grey;
      settings.triad = false;  // its axes have colours of their own
      Scene scene(boxes, settings);
      scene.look(View::front);
      const Image plain = draw_image(scene, width, height);
      scene.set_actions({glyphs[i]});
      const Image shown = draw_image(scene, width, height);
      EXPECT_GT(count_of(shown, rim), count_of(plain, rim) + 5);
      EXPECT_FALSE(shows_lit(plain, own));
      EXPECT_TRUE(shows_lit(shown, own)) << "the rim lies over the sign";
    }
}

TEST(ActionImage, FitKeepsWholeArrowsInView) {
  const BlockSystem boxes = two_boxes();
  Project project;
  // The boxes fill the picture from side to side, where the plate is pulled, and a tall arrow presses on one of them.
  project.loads = {{.block = "plate", .at = Vec3(2.5, 0, 0), .force = {1e5, 0, 0}},
                   {.block = "B1", .at = Vec3(0.5, 0.5, 1), .force = {0, 0, -1e5}}};
  GlyphsInView view(boxes, project);
  view.scene.fit();
  const auto pixels = view.found();
  EXPECT_TRUE(std::ranges::any_of(pixels, [](const auto& p) { return p.y < picture_height / 3; })) << "none is shown";
  for (const auto& [x, y, kind] : pixels) {
    EXPECT_GT(y, 1) << "cut off at the top, " << x;
    EXPECT_LT(x, picture_width - 2) << "cut off at the right, " << y;
  }
}

TEST(ActionImage, AClickFindsTheGlyphAndItGoesWithItsBlock) {
  const BlockSystem slope = jointed_slope();
  GlyphsInView view(slope, acted_on(slope));
  const auto place_of = [&](Kind kind) {
    Vec3 sum = Vec3::Zero();
    for (const auto& pixel : view.found())
      if (pixel.kind == kind) sum += Vec3(pixel.x, pixel.y, 1);
    return sum;  // its last: how many pixels
  };
  for (const Kind kind : {Kind::load, Kind::support, Kind::monitor})
    EXPECT_GT(place_of(kind).z(), 10) << static_cast<int>(kind);
  EXPECT_EQ(place_of(Kind::velocity).z(), 0);
  const Vec3 before = place_of(Kind::monitor);
  view.scene.set_frame(slid(slope, 8, 1));
  const Vec3 after = place_of(Kind::monitor);
  ASSERT_GT(after.z(), 0);
  EXPECT_LT(after.x() / after.z(), before.x() / before.z() - 10);  // the slope falls to the west
  EXPECT_GT(after.y() / after.z(), before.y() / before.z() + 5);
}

TEST(ActionGlyphs, SayTheLargestOfATableAndWhetherALoadPushes) {
  const BlockSystem boxes = two_boxes();
  Project project;
  project.loads = {
      {.block = "B1", .at = {0.5, 0.5, 1}, .force = {0, 0, 0}, .table = {{0, {0, 0, 0}}, {1, {0, 0, -5e3}}}},
      {.block = "B2", .at = {1.5, 0.5, 1}, .force = {0, 0, 5e3}}};
  const auto glyphs = action_glyphs(project, boxes);
  ASSERT_EQ(glyphs.size(), 2u);
  EXPECT_EQ(glyphs[0].arrow, Vec3(0, 0, -5e3));
  EXPECT_EQ(glyphs[0].label, "5 kN");
  EXPECT_TRUE(glyphs[0].pushes);
  EXPECT_FALSE(glyphs[1].pushes);
  EXPECT_EQ(largest_of(glyphs, Kind::load), 5e3);
}

TEST(ActionGlyphs, OfABlockThatIsNotCutYetStandWhereTheProjectNamesIt) {
  const BlockSystem boxes = two_boxes();
  Project project;
  project.blocks.resize(1);
  project.blocks[0].name = "crest";
  project.blocks[0].at = {0.5, 0.5, 0.8};
  project.velocities = {{.block = "nobody", .linear = {1, 0, 0}}, {.block = "crest", .linear = {1, 0, 0}}};
  const auto glyphs = action_glyphs(project, boxes);
  ASSERT_EQ(glyphs.size(), 1u) << "one without a place is not shown at the origin";
  EXPECT_EQ(glyphs[0].index, 1);
  EXPECT_EQ(glyphs[0].at, Vec3(0.5, 0.5, 0.8));
}

TEST(ActionGlyphs, StressInSituIsShownByItsPrincipalValues) {
  const BlockSystem boxes = two_boxes();
  Project project;
  Voigt shear = Voigt::Zero();
  shear[3] = 1e6;  // pure shear in the plane of x and y: ±1 MPa at 45°
  project.in_situ = {{.blocks = {}, .stress = shear}};
  const auto glyphs = action_glyphs(project, boxes);
  ASSERT_EQ(glyphs.size(), 3u);
  EXPECT_NEAR(glyphs[0].cross[0].value, -1e6, 1);
  EXPECT_NEAR(glyphs[0].cross[2].value, 1e6, 1);
  EXPECT_NEAR(std::abs(glyphs[0].cross[2].direction.dot(Vec3(1, 1, 0).normalized())), 1, 1e-9);
}

}  // namespace
}  // namespace talus
