#include <cmath>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/scenes/scene_groups.hpp"
#include "verification/hard_cases/shapes.hpp"

// Neighbours that differ by a factor of a thousand or a million, and joints and materials at the ends of their range.
namespace talus {

namespace {

const char* const ratio_group = "ratios";

Material with_density(Material material, double density) {
  material.name = significant(density) + " kg/m³";
  material.density = density;
  return material;
}

Material with_stiffness(Material material, double young) {
  material.name = significant(young) + " Pa";
  material.young = young;
  return material;
}

/// Two cubes on each other, on a floor, of the materials that come after the scene's first.
CaseScene two_cubes(const Material& lower, const Material& upper, double side, BodyKind body) {
  CaseScene scene = rock_scene(30);
  const int below = scene.add_material(lower), above = scene.add_material(upper);
  scene.add_fixed_box("floor", Vec3(-3, -3, -1) * side, Vec3(3, 3, 0) * side);
  const int cells = body == BodyKind::rigid ? 1 : 2;
  const TetMesh mesh = box_mesh(Vec3(-0.5, -0.5, 0) * side, Vec3(0.5, 0.5, 1) * side, cells, cells, cells);
  scene.add_block("lower", mesh, body, below);
  scene.add_block("upper", placed(mesh, {0, 0, side}), body, above);
  scene.project.solver.sleep_tolerance = 0;  // they are to rest by themselves
  scene.project.stages = {static_stage(0.1, 100), dynamic_stage(2e-3, 1)};
  return scene;
}

constexpr double light = 2.6, heavy = 2.6e6;  // kg/m³

/// The heavy cube presses with 2.6e7 Pa, which rock of 50 GPa bears without a mark. A fifth of the upper one's weight
/// is less than friction, tan 30°, holds.
HardCase masses(bool is_heavy_above, bool is_pushed) {
  const std::string where = is_heavy_above ? "above" : "below";
  return {.name = "mass_million_" + where + (is_pushed ? "_pushed" : ""),
          .group = ratio_group,
          .title = "Cubes of masses 1 : 1e6, the heavy one " + where + (is_pushed ? ", the upper one pushed" : ""),
          .expected = {all_rest(0, 1e-6)},
          .build = [=] {
            const Material rock = rock_scene(0).project.materials[0];
            const double upper = is_heavy_above ? heavy : light;
            CaseScene scene = two_cubes(with_density(rock, is_heavy_above ? light : heavy), with_density(rock, upper),
                                        1, BodyKind::rigid);
            if (is_pushed)
              scene.project.loads = {{.block = "upper", .at = {0, 0, 1.5}, .force = {0.2 * 9.81 * upper, 0, 0}}};
            return scene;
          }};
}

constexpr double soft = 1e6, hard = 1e12, cube_side = 0.1, cube_density = 1000;  // Pa, Pa, m, kg/m³

/// The soft cube shortens under the other's weight and half of its own; contacts, of 10 E/h, add a fifth of what two
/// weights and a tenth of what one would shorten it by.
HardCase stiffnesses(bool is_hard_above) {
  const double weights = 1 + 0.5 + 2 * 0.1 + 0.1, sag = weights * cube_density * 9.81 * cube_side * cube_side / soft;
  std::vector<HardCaseExpectation> expectations{all_rest(0, 1e-6)};
  if (is_hard_above) expectations.push_back(travels("upper", -Vec3::UnitZ(), sag, 0.1));
  return {.name = std::string("stiffness_million_") + (is_hard_above ? "above" : "below"),
          .group = ratio_group,
          .title = std::string("Cubes of stiffnesses 1 : 1e6, the hard one ") + (is_hard_above ? "above" : "below"),
          .expected = expectations,
          .build = [=] {
            Material material = with_density(rock_scene(0).project.materials[0], cube_density);
            material.poisson = 0;
            const Material lower = with_stiffness(material, is_hard_above ? soft : hard);
            const Material upper = with_stiffness(material, is_hard_above ? hard : soft);
            return two_cubes(lower, upper, cube_side, BodyKind::tetrahedra);
          }};
}

constexpr double grain = 1e-3;  // m

/// A grain on a cube a thousand times as wide; dropped, from ten times its own size.
HardCase grain_on_cube(bool is_dropped) {
  const double drop = is_dropped ? 10 * grain : 0;
  std::vector<HardCaseExpectation> expectations{rests("cube", 0, 1e-6)};
  if (is_dropped)
    expectations.insert(expectations.end(), {travels("grain", -Vec3::UnitZ(), drop, 0.01), stops("grain", 1e-3)});
  else
    expectations.push_back(rests("grain", 0, 1e-3 * grain));
  return {.name = std::string("size_thousand_above") + (is_dropped ? "_dropped" : ""),
          .group = ratio_group,
          .title = std::string("Grain of 1 mm on a cube of 1 m") + (is_dropped ? ", dropped by 1 cm" : ""),
          .expected = expectations,
          .build = [=] {
            CaseScene scene = rock_scene(30);
            scene.add_fixed_box("floor", {-3, -3, -1}, {3, 3, 0});
            scene.add_block("cube", placed(cube(1), {0, 0, 0.5}), BodyKind::rigid);
            scene.add_block("grain", placed(cube(grain), {0.2, 0.1, 1 + grain / 2 + drop}), BodyKind::rigid);
            scene.project.stages = {static_stage(0.01, 10), dynamic_stage(1e-3, 1)};
            if (is_dropped) {
              scene.project.stages[0].blocks = {{.name = "grain", .body = BodyKind::fixed}};
              scene.project.stages[1].blocks = {{.name = "grain", .body = BodyKind::rigid}};
            }
            return scene;
          }};
}

/// The cube weighs 26 kg: 6.4e7 Pa on each of the four grains. In solid rock they would bear 6.4e9 Pa.
HardCase cube_on_grains() {
  return {.name = "size_thousand_below",
          .group = ratio_group,
          .title = "Cube of 1 m and 26 kg/m³ on four grains of 1 mm",
          .expected = {all_rest(0, 1e-6)},
          .build = [] {
            CaseScene scene = rock_scene(30);
            const int foam = scene.add_material(with_density(scene.project.materials[0], 26));
            scene.add_fixed_box("floor", {-3, -3, -1}, {3, 3, 0});
            for (int i = 0; i < 4; ++i) {
              const Vec3 place(i & 1 ? 0.4 : -0.4, i & 2 ? 0.4 : -0.4, grain / 2);
              scene.add_block("grain " + std::to_string(i + 1), placed(cube(grain), place), BodyKind::rigid);
            }
            scene.add_block("cube", placed(cube(1), {0, 0, 0.5 + grain}), BodyKind::rigid, foam);
            scene.project.solver.sleep_tolerance = 0;
            scene.project.stages = {static_stage(0.01, 50), dynamic_stage(1e-3, 1)};
            return scene;
          }};
}

HardCase frictionless_slide() {
  const double dip = 30, seconds = 2;
  return {.name = "friction_0_slides",
          .group = ratio_group,
          .title = "Block without friction on 30°",
          .source = "g sin α t²/2",
          .expected = {travels("block", Vec3::UnitX(), 9.81 * std::sin(radians(dip)) * seconds * seconds / 2, 1e-3)},
          .build = [=] {
            CaseScene scene = rock_scene(0);
            tilt(scene, dip);
            scene.add_fixed_box("slab", {-2, -2, -1}, {14, 2, 0});
            scene.add_box("block", {-0.5, -0.5, 0}, {0.5, 0.5, 1});
            scene.project.stages = {dynamic_stage(2e-3, seconds)};
            return scene;
          }};
}

/// Nothing but shape holds it: a wedge of 90° in a groove, of two slabs that dip by 45° each.
HardCase frictionless_wedge() {
  return {.name = "friction_0_rests",
          .group = ratio_group,
          .title = "Cube without friction on its edge between two slabs of 45°",
          .expected = {rests("cube", 0, 1e-6)},
          .build = [] {
            CaseScene scene = rock_scene(0);
            scene.project.gravity = 9.81 * Vec3(-1, 0, -1).normalized();
            scene.add_fixed_box("slab", {0, -2, -1}, {3, 2, 0});
            scene.add_fixed_box("wall", {-1, -2, -1}, {0, 2, 3});
            scene.add_block("cube", box_mesh({0, -0.5, 0}, {1, 0.5, 1}, 1, 1, 1), BodyKind::rigid);
            scene.project.stages = {static_stage(0.01, 20), dynamic_stage(2e-3, 2)};
            return scene;
          }};
}

/// tan 89° = 57. A plate ten times as wide as thick tips over at 84.3°.
HardCase rough_plate() {
  return {.name = "friction_89_rests",
          .group = ratio_group,
          .title = "Plate 10 : 1 with friction of 89° on 80°",
          .expected = {rests("plate", 0, 1e-6)},
          .build = [] {
            CaseScene scene = rock_scene(89);
            tilt(scene, 80);
            scene.add_fixed_box("slab", {-3, -3, -1}, {3, 3, 0});
            scene.add_block("plate", box_mesh({-0.5, -0.5, 0}, {0.5, 0.5, 0.1}, 4, 4, 1), BodyKind::rigid);
            scene.project.stages = {static_stage(0.01, 20), dynamic_stage(2e-3, 2)};
            return scene;
          }};
}

/// A cube that strikes its edge so that it sticks turns on at 3v/4s and comes over from v² = 1.1 g s on: 3.3 m/s.
HardCase rough_throw() {
  return {.name = "friction_89_thrown",
          .group = ratio_group,
          .title = "Cube with friction of 89° thrown along a floor at 5 m/s",
          .expected = {topples("cube", 45), stays_before(Vec3::Zero(), Vec3::UnitZ())},
          .build = [] {
            CaseScene scene = rock_scene(89);
            scene.add_fixed_box("floor", {-5, -5, -1}, {25, 5, 0});
            scene.add_block("cube", placed(cube(1), {0, 0, 0.5}), BodyKind::rigid);
            scene.project.velocities = {{.block = "cube", .linear = {5, 0, 0}}};
            scene.project.stages = {dynamic_stage(1e-3, 2)};
            return scene;
          }};
}

/// Rubber of 1e9 Pa. At rest, its centroid has come down by less than a free column would at its top; dropped, it stays
/// where it has landed.
HardCase poisson(const std::string& digits, double ratio, bool is_dropped) {
  const double young = 1e9, density = 1000, drop = is_dropped ? 0.01 : 0, sag = density * 9.81 / young;  // sag: m
  std::vector<HardCaseExpectation> expectations{rests("cube", 0, 1e-6), rests("cube", -1, sag)};
  if (is_dropped) expectations = {travels("cube", -Vec3::UnitZ(), drop, 0.01), stops("cube", 1e-3)};
  return {.name = "poisson_" + digits + (is_dropped ? "_dropped" : "_rests"),
          .group = ratio_group,
          .title = "Cube with Poisson's ratio " + significant(ratio, 4) + (is_dropped ? ", dropped by 1 cm" : ""),
          .expected = expectations,
          .build = [=] {
            CaseScene scene = rock_scene(30);
            scene.project.materials[0] = {.name = "rubber", .density = density, .young = young, .poisson = ratio};
            scene.add_fixed_box("floor", {-3, -3, -1}, {3, 3, 0});
            scene.add_block("cube", box_mesh({-0.5, -0.5, drop}, {0.5, 0.5, 1 + drop}, 3, 3, 3), BodyKind::tetrahedra);
            scene.project.stages = {dynamic_stage(1e-3, 1)};
            if (!is_dropped) scene.project.stages.insert(scene.project.stages.begin(), static_stage(0.01, 20));
            return scene;
          }};
}

}  // namespace

std::vector<HardCase> ratio_scenes() {
  std::vector<HardCase> scenes;
  for (const bool is_pushed : {false, true})
    for (const bool is_heavy_above : {true, false}) scenes.push_back(masses(is_heavy_above, is_pushed));
  for (const bool is_hard_above : {true, false}) scenes.push_back(stiffnesses(is_hard_above));
  for (const bool is_dropped : {false, true}) scenes.push_back(grain_on_cube(is_dropped));
  scenes.push_back(cube_on_grains());
  scenes.insert(scenes.end(), {frictionless_slide(), frictionless_wedge(), rough_plate(), rough_throw()});
  for (const bool is_dropped : {false, true}) {
    scenes.push_back(poisson("0", 0, is_dropped));
    scenes.push_back(poisson("49", 0.49, is_dropped));
    scenes.push_back(poisson("4999", 0.4999, is_dropped));
  }
  return scenes;
}

}  // namespace talus
