#include <cmath>

#include "base/units.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/classic/classic_scenes.hpp"

namespace talus {

namespace {

/// A regular tetrahedron with an edge on each wall of a slot and one below. It falls by 0.1 m; standing on its edge it
/// cannot turn about any axis but by the play over its width, 5e-7 rad.
HardCase tetrahedron_in_slot() {
  constexpr double drop = 0.1, play = 5e-7;  // m
  return {.name = "tetrahedron_in_slot",
          .group = classic_group,
          .title = "Tetrahedron falls in a slot 5e-7 m wider",
          .source = "Li et al. 2020 (IPC)",
          .expected = {travels("tetrahedron", -Vec3::UnitZ(), drop, 0.01), rests("tetrahedron", -1, 1.05 * drop, 0.01),
                       stops("tetrahedron", 1e-3)},
          .build = [] {
            CaseScene scene = scene_of(hard_stone(), 0);
            scene.add_block("slot", slotted_box(1 + play, 1.5, 2, 2, 0.5), BodyKind::fixed);
            TetMesh mesh{{{0.5, 0.5, 0.5}, {0.5, -0.5, -0.5}, {-0.5, 0.5, -0.5}, {-0.5, -0.5, 0.5}}, {{0, 1, 2, 3}}};
            if (volume(mesh) < 0) std::swap(mesh.tetrahedra[0][0], mesh.tetrahedra[0][1]);
            scene.add_block("tetrahedron", placed(mesh, {0, 0, -1 + drop}), BodyKind::tetrahedra);
            scene.project.stages = {dynamic_stage(1e-3, 2)};
            return scene;
          }};
}

CaseScene cube_over_bars_scene(double turn) {
  constexpr double half_gap = 0.4, side = 1;  // m
  const double sine = std::sin(radians(std::abs(turn))), cosine = std::cos(radians(turn));
  // The lower edge is as deep as the faces are wide where bars meet them: at the cube's ends when it is turned.
  const double depth = (half_gap - side / 2 * sine) / cosine;
  CaseScene scene = scene_of(hard_stone(), 0.5);
  scene.add_fixed_box("floor", {-4, -4, -3}, {4, 4, -2});
  for (const double x : {-half_gap - 1, half_gap})
    scene.add_fixed_box(x < 0 ? "left bar" : "right bar", {x, -2, -1}, {x + 1, 2, 0});
  const Mat3 pose = turn_about(Vec3::UnitZ(), turn) * turn_about(Vec3::UnitY(), 45);
  scene.add_block("cube", placed(cube(side), pose, {0, 0, side * std::sqrt(0.5) - depth}), BodyKind::tetrahedra);
  if (turn == 0) scene.project.stages.push_back(static_stage(0.01, 10));
  scene.project.stages.push_back(dynamic_stage(2e-3, 5));
  return scene;
}

/// Two bars 0.8 m apart under a cube of 1 m on its edge. Square to the bars its lower faces rest on them along lines
/// whose normals meet 0.8 m above its edge, and its centre lies below that, at 0.71 m: it stays. Turned, each bar
/// touches it in a single point, and it comes to rest on something above the floor.
HardCase cube_over_bars(double turn) {
  const std::string angle = std::to_string(static_cast<int>(std::abs(turn)));
  return {
      .name = "cube_over_bars_" + (turn < 0 ? "minus_" + angle : angle),
      .group = classic_group,
      .title = "Cube on its edge over two bars, turned by " + (turn < 0 ? "−" + angle : angle) + "°",
      .source = "Erleben 2018",
      .expected = {stays_before({0, 0, -2}, Vec3::UnitZ()), turn == 0 ? rests("cube", 0, 1e-6) : stops("cube", 1e-2)},
      .build = [=] { return cube_over_bars_scene(turn); }};
}

/// Five columns of five cubes, evenly spread between walls: nothing moves, walls or not.
HardCase between_walls() {
  return {.name = "between_walls",
          .group = classic_group,
          .title = "25 cubes between walls 1e-3 m wider",
          .expected = {all_rest(0, 1e-6)},
          .build = [] {
            constexpr int count = 5;
            constexpr double play = 1e-3, gap = play / (count + 1);  // m
            CaseScene scene = scene_of(hard_stone(), 0.5);
            scene.add_fixed_box("floor", {-2, -1, -1}, {count + 2, 2, 0});
            scene.add_fixed_box("left wall", {-1, -1, 0}, {0, 2, count + 1});
            scene.add_fixed_box("right wall", {count + play, -1, 0}, {count + play + 1, 2, count + 1});
            for (int i = 0; i < count; ++i)
              for (int k = 0; k < count; ++k) {
                const double x = i * (1 + gap) + gap;
                scene.add_box("cube " + std::to_string(i * count + k + 1), Vec3(x, 0, k), Vec3(x + 1, 1, k + 1));
              }
            scene.project.stages = {static_stage(0.01, 50), dynamic_stage(2e-3, 1)};
            return scene;
          }};
}

/// A plate with 1e6 N on it comes down on eight cubes that stand in a box with 5 cm of play all round.
HardCase compactor() {
  return {.name = "compactor",
          .group = classic_group,
          .title = "Compactor presses on eight cubes with 1e6 N",
          .source = "Ferguson et al. 2021 (rigid IPC)",
          .expected = {stays_before({0, 0, 0}, Vec3::UnitZ()), stops("plate", 1e-3),
                       travels("plate", -Vec3::UnitZ(), 0.1, 0.01)},
          .build = [] {
            constexpr double play = 0.05, inside = 2 + 3 * play;  // m
            CaseScene scene = scene_of(hard_stone(), 0.5);
            scene.add_block("box",
                            grid_mesh({-1, 0, inside, inside + 1}, {-1, 0, inside, inside + 1}, {-1, 0, 4},
                                      [](int i, int j, int k) { return i != 1 || j != 1 || k == 0; }),
                            BodyKind::fixed);
            for (int i = 0; i < 8; ++i) {
              const Vec3 low(play + (i & 1 ? 1 + play : 0), play + (i & 2 ? 1 + play : 0), i & 4 ? 1 : 0);
              scene.add_box("cube " + std::to_string(i + 1), low, low + Vec3::Ones());
            }
            const Vec3 low(play / 2, play / 2, 2.1), high(inside - play / 2, inside - play / 2, 2.4);
            scene.add_box("plate", low, high);
            scene.project.loads = {{.block = "plate", .at = (low + high) / 2, .force = {0, 0, -1e6}}};
            scene.project.stages = {dynamic_stage(5e-4, 1)};
            return scene;
          }};
}

}  // namespace

std::vector<HardCase> tight_fit_scenes() {
  return {tetrahedron_in_slot(), cube_over_bars(0), cube_over_bars(30),
          cube_over_bars(-30),   between_walls(),   compactor()};
}

}  // namespace talus
