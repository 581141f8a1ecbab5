#include "model/stages.hpp"
#include "verification/hard_cases/classic/classic_scenes.hpp"

namespace talus {

namespace {

/// Five cubes, 0.01 m between each and the next: the k-th comes down by k gaps.
HardCase gapped_stack() {
  constexpr int count = 5;
  constexpr double gap = 0.01;  // m
  const auto name = [](int k) { return "cube " + std::to_string(k); };
  std::vector<HardCaseExpectation> expectations;
  for (int k = 1; k <= count; ++k) {
    expectations.push_back(travels(name(k), -Vec3::UnitZ(), k * gap, 0.01));
    expectations.push_back(stops(name(k), 1e-3));
  }
  return {.name = "stack_with_gaps",
          .group = classic_group,
          .title = "Five cubes fall onto each other from gaps of 0.01 m",
          .expected = expectations,
          .build = [=] {
            CaseScene scene = scene_of(hard_stone(), 0.5);
            scene.add_fixed_box("floor", {-2, -2, -1}, {3, 3, 0});
            for (int k = 1; k <= count; ++k) {
              const double top = k * (1 + gap);
              scene.add_box(name(k), Vec3(0, 0, top - 1), Vec3(1, 1, top));
            }
            scene.project.stages = {dynamic_stage(1e-3, 2)};
            return scene;
          }};
}

CaseScene centred_stack(const std::vector<double>& sides, const std::vector<int>& materials, CaseScene scene) {
  scene.add_fixed_box("floor", {-8, -8, -2}, {8, 8, 0});
  double level = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    scene.add_block("cube " + std::to_string(i + 1), placed(cube(sides[i]), {0, 0, level + sides[i] / 2}),
                    BodyKind::tetrahedra, materials[i]);
    level += sides[i];
  }
  // One cube of six tetrahedra gives more to one side. What leans on it comes to its balance by ω² of some 7/s², slowly
  // where velocities are taken out in each step: steps are long.
  scene.project.stages = {static_stage(0.2, 200), dynamic_stage(2e-3, 2)};
  return scene;
}

HardCase pyramid() {
  return {.name = "pyramid_10_to_1",
          .group = classic_group,
          .title = "Cubes of sides 10, 8, 4, 2, 1 on each other",
          .expected = {all_rest(0, 1e-6)},
          .build = [] {
            return centred_stack({10, 8, 4, 2, 1}, {0, 0, 0, 0, 0}, scene_of(hard_stone(), 0.5));
          }};
}

/// The small cube bears 1e8 Pa: 0.2 % of strain. As a spring against tilting, E·s⁴/12/s = 4e9 N·m, it is eight times
/// stiffer than m·g·h = 5e8 N·m asks for.
HardCase heavy_on_light() {
  return {.name = "heavy_on_light",
          .group = classic_group,
          .title = "Cube of side 10 and 1e4 kg/m³ on one of side 1 and 1e3 kg/m³",
          .expected = {all_rest(0, 1e-6)},
          .build = [] {
            Material light = hard_stone(), heavy = hard_stone();
            light.density = 1e3;
            heavy.name = "heavy";
            heavy.density = 1e4;
            CaseScene scene = scene_of(light, 0.5);
            return centred_stack({1, 10}, {0, scene.add_material(heavy)}, std::move(scene));
          }};
}

}  // namespace

std::vector<HardCase> stack_scenes() { return {gapped_stack(), pyramid(), heavy_on_light()}; }

}  // namespace talus
