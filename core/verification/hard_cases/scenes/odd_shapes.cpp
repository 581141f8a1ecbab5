#include <cmath>
#include <numbers>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/scenes/scene_groups.hpp"
#include "verification/hard_cases/shapes.hpp"

// Blocks that are long, thin, flat to nothing, hooked into each other, or all of one vertex.
namespace talus {

namespace {

const char* const shape_group = "shapes";
constexpr double shape_settled = 1e-6, shape_slow = 1e-3;  // m, m/s

/// A floor, the block on it or `drop` [m] above, and two seconds. At rest it yields by some ρg h²/2E = 3e-7 m.
HardCase on_floor(const std::string& name, const std::string& title, const TetMesh& mesh, BodyKind body, double drop) {
  std::vector<HardCaseExpectation> expectations{rests("block", -1, shape_settled)};
  if (drop > 0) expectations = {travels("block", -Vec3::UnitZ(), drop, 0.01), stops("block", shape_slow)};
  return {.name = name + (drop > 0 ? "_dropped" : "_rests"),
          .group = shape_group,
          .title = title + (drop > 0 ? ", dropped by " + significant(100 * drop) + " cm" : ", at rest"),
          .expected = expectations,
          .build = [=] {
            CaseScene scene = rock_scene(30);
            scene.add_fixed_box("floor", {-3, -3, -1}, {3, 3, 0});
            scene.add_block("block", placed(mesh, {0, 0, drop}), body);
            if (drop == 0) scene.project.stages.push_back(static_stage(0.01, 20));
            scene.project.stages.push_back(dynamic_stage(1e-3, 2));
            return scene;
          }};
}

TetMesh needle(double length, double width, int cells) {
  return box_mesh({-length / 2, -width / 2, 0}, {length / 2, width / 2, width}, cells, 1, 1);
}

/// Each is some ten steps of motion thick, and thinner than the mesh size that its long faces give it.
HardCase needles(int count) {
  return {.name = "needles_fall_" + std::to_string(count),
          .group = shape_group,
          .title = std::to_string(count) + " needles 100 : 1 fall across each other",
          .takes_long = count > 3,
          .expected = {stays_before(Vec3::Zero(), Vec3::UnitZ())},
          .build = [=] {
            CaseScene scene = rock_scene(30);
            scene.add_fixed_box("floor", {-3, -3, -1}, {3, 3, 0});
            for (int i = 0; i < count; ++i) {
              const Mat3 pose = turn_about(Vec3::UnitZ(), 37.0 * i) * turn_about(Vec3::UnitY(), 10 - 3.0 * i);
              scene.add_block("needle " + std::to_string(i + 1),
                              placed(needle(1, 0.01, 1), pose, {0, 0, 0.15 + 0.1 * i}), BodyKind::rigid);
            }
            scene.project.stages = {dynamic_stage(1e-3, 2)};
            return scene;
          }};
}

TetMesh plate(double side, double thickness) {
  return box_mesh({-side / 2, -side / 2, 0}, {side / 2, side / 2, thickness}, 4, 4, 1);
}

HardCase plates(int count) {
  return {.name = "plates_" + std::to_string(count) + "_rest",
          .group = shape_group,
          .title = std::to_string(count) + " rigid plates 1000 : 1 on each other across two rails",
          .expected = {all_rest(-1, shape_settled)},
          .build = [=] {
            constexpr double thickness = 1e-3;
            CaseScene scene = rock_scene(30);
            for (const double x : {-0.4, 0.4})
              scene.add_fixed_box(x < 0 ? "left rail" : "right rail", Vec3(x - 0.05, -1, -1), Vec3(x + 0.05, 1, 0));
            for (int i = 0; i < count; ++i)
              scene.add_block("plate " + std::to_string(i + 1), placed(plate(1, thickness), {0, 0, i * thickness}),
                              BodyKind::rigid);
            scene.project.stages = {static_stage(0.01, 50), dynamic_stage(1e-3, 1)};
            return scene;
          }};
}

/// A triangle with sides of 1 m and a point above its middle, so low that its faces rise by 1°.
TetMesh sliver() {
  const double inner = std::sqrt(3.0) / 6, height = inner * std::tan(radians(1));
  return {{{-0.5, -inner, 0}, {0.5, -inner, 0}, {0, 2 * inner, 0}, {0, 0, height}}, {{0, 1, 2, 3}}};
}

/// Its lower layer is as thin as dihedral angles of 1° make it.
TetMesh cube_with_slivers() {
  const std::vector<double> lines{-0.5, 0, 0.5};
  return grid_mesh(lines, lines, {0, 0.5 * std::tan(radians(1)), 0.5, 1}, [](int, int, int) { return true; });
}

/// A cone of a hundred flanks: as many tetrahedra meet in its tip, and 198 in its middle.
TetMesh cone(double radius, double height) {
  constexpr int flanks = 100;
  std::vector<Vec3> corners;
  std::vector<std::vector<int>> faces(1);
  for (int i = 0; i < flanks; ++i) {
    const double angle = 2 * std::numbers::pi * i / flanks;
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    faces[0].push_back(flanks - 1 - i);
    faces.push_back({i, (i + 1) % flanks, flanks});
  }
  corners.push_back({0, 0, height});
  return convex_mesh(corners, faces);
}

/// It may stand as it was put or come down to a side.
HardCase cone_on_tip(double drop) {
  return {.name = std::string("cone_on_tip") + (drop > 0 ? "_dropped" : "_rests"),
          .group = shape_group,
          .title = std::string("Cone of a hundred flanks on its tip") + (drop > 0 ? ", dropped by 5 cm" : ""),
          .expected = {comes_down_aside("cone", Vec3::UnitZ(), drop + 1e-3), stays_before(Vec3::Zero(), Vec3::UnitZ())},
          .build = [=] {
            CaseScene scene = rock_scene(30);
            scene.add_fixed_box("floor", {-3, -3, -1}, {3, 3, 0});
            scene.add_block("cone", placed(cone(0.5, 1), turn_about(Vec3::UnitX(), 180), {0, 0, 1 + drop}),
                            BodyKind::tetrahedra);
            scene.project.stages = {dynamic_stage(1e-3, 2)};
            return scene;
          }};
}

constexpr double bar = 0.2;  // m, of hooks and rails

/// A letter J in the plane y = 0, 4 bars wide and 6 high; its inside, 2 bars wide, begins at the origin.
TetMesh bent_bar() {
  TetMesh mesh = hook(2, 5, 1);
  for (Vec3& node : mesh.nodes) node *= bar;
  return mesh;
}

/// A free hook upside down in a fixed one, across it. Its centroid lies 0.6 bars beside the middle of its inside, more
/// than the half bar that it rests on: it tips and swings. From no point of its inside is that centroid farther off
/// than 1.94 bars.
HardCase hooks() {
  return {.name = "hook_swings",
          .group = shape_group,
          .title = "Hook swings in a hook",
          .expected = {topples("free hook", 5), stays_before({0, 0, -2 * bar}, Vec3::UnitZ())},
          .build = [] {
            CaseScene scene = rock_scene(30);
            scene.add_block("hook", bent_bar(), BodyKind::fixed);
            const Mat3 turn = turn_about(Vec3::UnitZ(), 90) * upside_down();
            scene.add_block("free hook", placed(bent_bar(), turn, {bar, -bar, 0}), BodyKind::rigid);
            scene.project.stages = {dynamic_stage(1e-3, 3)};
            return scene;
          }};
}

/// The arms of a T lie on the lips of a rail, face on face. Pulled with ten times its weight it stays, too.
HardCase tee_in_rail(bool is_pulled) {
  return {.name = std::string("tee_in_rail") + (is_pulled ? "_pulled" : "_hangs"),
          .group = shape_group,
          .title = std::string("T hangs in a rail") + (is_pulled ? ", pulled with ten times its weight" : ""),
          .expected = {rests("tee", 0, shape_settled)},
          .build = [=] {
            CaseScene scene = rock_scene(30);
            const std::vector<double> lines{-3 * bar, -2 * bar, -bar, bar, 2 * bar, 3 * bar};
            const std::vector<double> levels{-bar, 0, 2 * bar, 3 * bar};
            scene.add_block(
                "rail",
                grid_mesh(lines, {-1, 1}, levels,
                          [](int i, int, int k) { return k == 2 || i == 0 || i == 4 || (k == 0 && i != 2); }),
                BodyKind::fixed);
            const std::vector<double> widths{-1.9 * bar, -0.9 * bar, 0.9 * bar, 1.9 * bar};
            scene.add_block(
                "tee",
                grid_mesh(widths, {-0.2, 0.2}, {-4 * bar, 0, bar}, [](int i, int, int k) { return k == 1 || i == 1; }),
                BodyKind::tetrahedra);
            const double weight = scene.system.blocks.back().volume * 2600 * 9.81;
            if (is_pulled)
              scene.project.loads = {{.block = "tee", .at = {0, 0, -3 * bar}, .force = {0, 0, -10 * weight}}};
            scene.project.stages = {static_stage(0.01, 50), dynamic_stage(1e-3, 1)};
            return scene;
          }};
}

}  // namespace

std::vector<HardCase> odd_shape_scenes() {
  std::vector<HardCase> scenes;
  for (const double drop : {0.0, 0.05}) {
    scenes.push_back(on_floor("needle_rigid", "Rigid needle 1000 : 1", needle(1, 1e-3, 1), BodyKind::rigid, drop));
    scenes.push_back(on_floor("needle_elastic", "Needle 1000 : 1", needle(1, 1e-3, 20), BodyKind::tetrahedra, drop));
    scenes.push_back(on_floor("plate_rigid", "Rigid plate 1000 : 1", plate(1, 1e-3), BodyKind::rigid, drop));
    scenes.push_back(on_floor("plate_elastic", "Plate 1000 : 1", plate(1, 1e-3), BodyKind::tetrahedra, drop));
    scenes.push_back(on_floor("sliver_rigid", "Rigid tetrahedron with angles of 1°", sliver(), BodyKind::rigid, drop));
    scenes.push_back(on_floor("sliver_elastic", "Tetrahedron with angles of 1°", sliver(), BodyKind::tetrahedra, drop));
    scenes.push_back(
        on_floor("slivers", "Cube on a layer of slivers of 1°", cube_with_slivers(), BodyKind::tetrahedra, drop));
    scenes.push_back(
        on_floor("cone", "Cone of a hundred flanks on its base", cone(0.5, 1), BodyKind::tetrahedra, drop));
    scenes.push_back(cone_on_tip(drop));
  }
  scenes.insert(scenes.end(),
                {needles(3), needles(10), plates(2), plates(10), hooks(), tee_in_rail(false), tee_in_rail(true)});
  return scenes;
}

}  // namespace talus
