#include <cmath>

#include "base/units.hpp"
#include "geometry/block_builder.hpp"
#include "io/project_file.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/scenes/scene_groups.hpp"

// Scenes that were drawn at random, and that an earlier method failed. Each is a project file in resources/hard_cases.

extern const char found_scene_cavern_not_converged[];
extern const char found_scene_chain_3_links[];
extern const char found_scene_crosses_deep[];
extern const char found_scene_cube_5cm_through_floor[];
extern const char found_scene_false_stick_far[];
extern const char found_scene_plate_through_wall[];
extern const char found_scene_restitution_makes_energy[];
extern const char found_scene_ridge_tetrahedra_growth[];
extern const char found_scene_shaking_tower_growth[];
extern const char found_scene_slab_1e_minus_9_above_boxes[];
extern const char found_scene_slope_35_tetrahedra[];
extern const char found_scene_slope_59_static_slow[];
extern const char found_scene_slope_71_affine[];

namespace talus {

namespace {

HardCaseExpectation stays_above(double height) { return stays_before({0, 0, height}, Vec3::UnitZ()); }

HardCase found(const char* name, const char* title, const char* project_file, std::vector<HardCaseExpectation> expected,
               std::string shortfall = {}, bool takes_long = false) {
  return {.name = name,
          .group = "found at random",
          .title = title,
          .takes_long = takes_long,
          .shortfall = std::move(shortfall),
          .expected = std::move(expected),
          .build = [=] {
            CaseScene scene{.project = parse_project(project_file), .system = {}};
            NoProgress nobody;
            scene.system = build_blocks(scene.project, {}, nobody);
            return scene;
          }};
}

std::vector<HardCase> passages() {
  return {found("plate_through_wall", "Plate of 1 cm at 30 m/s meets a wall, 6 cm a step",
                found_scene_plate_through_wall, {stays_before({0, 0, 0}, -Vec3::UnitX())}),
          found("cube_5cm_through_floor", "Cube of 5 cm falls on a floor, 4 cm a step",
                found_scene_cube_5cm_through_floor, {stays_above(0)})};
}

/// s = ½ g (sin θ − cos θ tan φ) t²
HardCase far_slope() {
  constexpr double friction = 24.288090343927, dip = friction + 0.05, time = 2;  // degrees, s
  const double steeper = std::sin(radians(dip)) - std::cos(radians(dip)) * std::tan(radians(friction));
  return found("false_stick_far", "Block on a slope 0.05° steeper than friction, 4.7e6 m from the origin",
               found_scene_false_stick_far,
               {travels("b", Vec3(-8.3282318925, 14.1283899658, -7.4181630646).normalized(),
                        9.81 / 2 * steeper * time * time, 1e-4)});
}

std::vector<HardCase> energies() {
  return {found("restitution_makes_energy", "Box dropped by 1 m, restitution 1, friction 25°",
                found_scene_restitution_makes_energy, {stays_above(0)}),
          found("ridge_tetrahedra_growth", "Ridge of a meshed wedge falls on a ridge across it",
                found_scene_ridge_tetrahedra_growth, {stays_above(0)}),
          found("shaking_tower_growth", "Tower of four boxes on a shaken table", found_scene_shaking_tower_growth,
                {stays_above(0)})};
}

std::vector<HardCase> crowds() {
  return {found("cavern_not_converged", "107 blocks round a cavern", found_scene_cavern_not_converged, {stays_above(3)},
                {}, true),
          found("chain_3_links", "Chain of rings of sixty faces swings", found_scene_chain_3_links, {stays_above(-11)}),
          found("crosses_deep", "Eight crosses poured into a box", found_scene_crosses_deep, {stays_above(0)}),
          found("slab_1e_minus_9_above_boxes", "Slab 1e-9 m above eight boxes", found_scene_slab_1e_minus_9_above_boxes,
                {all_rest(-1, 1e-3)})};
}

std::vector<HardCase> slopes() {
  return {found("slope_35_tetrahedra", "35 meshed blocks of three random joint sets slide",
                found_scene_slope_35_tetrahedra, {stays_above(0)}),
          found("slope_59_static_slow", "59 blocks of three random joint sets, a static stage first",
                found_scene_slope_59_static_slow, {stays_above(0)}),
          found("slope_71_affine", "71 affine blocks of three random joint sets slide", found_scene_slope_71_affine,
                {stays_above(0)}, {}, true)};
}

}  // namespace

std::vector<HardCase> found_scenes() {
  std::vector<HardCase> all = passages();
  all.push_back(far_slope());
  for (const auto& group : {energies(), crowds(), slopes()}) all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace talus
