// Every way of displaying results, light and dark, of one run.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>
#include <string>
#include <vector>

#include "images/baseline.hpp"
#include "images/solved_scene.hpp"
#include "render/scene/action_glyphs.hpp"
#include "render/scene/block_surface.hpp"
#include "render/scene/offscreen.hpp"
#include "render/scene/slope_view.hpp"
#include "results/field.hpp"

namespace talus {
namespace {

constexpr int display_width = 480, display_height = 300;

/// What a way of displaying changes of the picture that nobody has changed anything of.
struct Display {
  std::string name;
  std::function<void(SceneSettings&)> set = [](SceneSettings&) {};
  std::function<void(Scene&)> show = [](Scene&) {};
};

Display field(const std::string& name, const std::string& shown, std::function<void(SceneSettings&)> more) {
  return {name, [=](SceneSettings& settings) {
            settings.field = field_named(shown);
            more(settings);
          }};
}

Display seen_from(const std::string& name) {
  return {"view." + name, [](SceneSettings&) {}, [name](Scene& scene) { scene.look(view_named(name)); }};
}

/// Across the slab, so that its inside is seen.
SectionPlane across(const BlockSystem& system) { return {bounds(system).center(), -Vec3::UnitY()}; }

BlockColours by_body(const BlockSystem& system) {
  const std::vector<Rgb> palette(block_palette().begin(), block_palette().end());
  BlockColours colours{"Body", {}, {{palette[0], "rigid"}, {palette[1], "others"}}};
  for (const Block& block : system.blocks) colours.colours.push_back(palette[block.body == BodyKind::rigid ? 0 : 1]);
  return colours;
}

/// A run that was hard between two of the blocks.
std::vector<ConvergenceTrouble> trouble_of(const BlockSystem& system) {
  ConvergenceTrouble trouble;
  trouble.blocks = {system.blocks[1].name, system.blocks[2].name};
  trouble.rest_position = system.blocks[1].mesh.nodes.front();
  return {trouble};
}

std::vector<Display> all_displays() {
  const BlockSystem& system = sliding_slab().system;
  std::vector<Display> all{
      {"blocks"},
      {"undeformed", [](SceneSettings&) {}, [](Scene& scene) { scene.clear_frame(); }},
      {"edges.none", [](SceneSettings& s) { s.edges = Edges::none; }},
      {"edges.mesh", [](SceneSettings& s) { s.edges = Edges::mesh; }},
      {"enlarged", [](SceneSettings& s) { s.deformation_scale = 5; }},
      {"apart", [](SceneSettings& s) { s.explosion = 0.6; }},
      {"contacts", [](SceneSettings& s) { s.contacts = true; }},
      {"arrows.velocity", [](SceneSettings& s) { s.arrows = Arrows::velocity; }},
      {"arrows.force", [](SceneSettings& s) { s.arrows = Arrows::contact_force; }},
      {"crosses", [](SceneSettings& s) { s.arrows = Arrows::principal_stress; }},
      {"ghosts", [](SceneSettings& s) { s.rock_opacity = 0.25; }},
      {"parallel", [](SceneSettings& s) { s.parallel_projection = true; }},
      {"coarse", [](SceneSettings& s) { s.fine = false; }},
      {"bare", [](SceneSettings& s) { s.title.clear(), s.legend = s.time_stamp = s.triad = s.scale_bar = false; }},
      {"remark", [](SceneSettings& s) { s.remark = "2 × slower", s.text_height = 16; }},
      {"colours.by_body",
       [&](SceneSettings& s) { s.block_colours = std::make_shared<const BlockColours>(by_body(system)); }},
      {"places",
       [&](SceneSettings& s) {
         s.places = {{system.blocks[2].mesh.nodes.back(), 2, "0.3 mm thick"}};
       }},
      {"actions", [](SceneSettings&) {},
       [](Scene& scene) { scene.set_actions(action_glyphs(sliding_slab().project, sliding_slab().system)); }},
      {"trouble", [](SceneSettings&) {}, [&](Scene& scene) { scene.set_troubles(trouble_of(system)); }},
      {"hidden_and_selected", [](SceneSettings&) {},
       [](Scene& scene) {
         scene.set_hidden({1, 2});
         scene.set_selected({3});
         scene.set_hovered(4);
       }},
      field("section", "displacement", [&](SceneSettings& s) { s.section = across(system); }),
      field("only", "displacement",
            [](SceneSettings& s) {
              s.only = ValueRange{0.35, 0.6};
            }),
      field("range", "displacement",
            [](SceneSettings& s) {
              s.range = ValueRange{0, 0.5};
            }),
      field("walls.apart", "joint.slip", [](SceneSettings& s) { s.explosion = 0.6; }),
      field("walls.only", "joint.opening",
            [](SceneSettings& s) {
              s.only = ValueRange{0.001, 1};
            }),
      field("crosses.on_stress", "stress.min_principal", [](SceneSettings& s) { s.arrows = Arrows::principal_stress; }),
      field("mesh.on_strain", "strain.max_shear", [](SceneSettings& s) { s.edges = Edges::mesh; })};
  for (const char* view : {"iso", "front", "back", "left", "right", "top"}) all.push_back(seen_from(view));
  return all;
}

class DisplayImage : public testing::TestWithParam<Theme> {};

TEST_P(DisplayImage, OfEachKindIsAsItWas) {
  const SolvedScene& slab = sliding_slab();
  for (const Display& display : all_displays()) {
    SceneSettings settings;
    settings.theme = GetParam();
    settings.title = "Quarry, north face";
    display.set(settings);
    Scene scene(slab.system, settings);
    scene.set_stage_names({"settle", "soften and let go"});
    look_at_slope(scene, slab.system, slab.frame.get());
    scene.set_frame(slab.frame);
    display.show(scene);
    expect_baseline(draw_image(scene, display_width, display_height),
                    "Display." + display.name + (settings.theme == Theme::dark ? ".dark" : ".light"));
  }
}

INSTANTIATE_TEST_SUITE_P(Light, DisplayImage, testing::Values(Theme::light));
INSTANTIATE_TEST_SUITE_P(Dark, DisplayImage, testing::Values(Theme::dark));

}  // namespace
}  // namespace talus
