#include <Eigen/Geometry>
#include <cmath>
#include <iterator>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/scenes/crowd_parts.hpp"
#include "verification/hard_cases/shapes.hpp"

// Many blocks that stand: each rests on others, and one that yields is seen in all.
namespace talus {

namespace {

void add_rigid_box(CaseScene& scene, const Vec3& min, const Vec3& max) {
  scene.add_block("block " + std::to_string(scene.system.blocks.size()), box_mesh(min, max, 1, 1, 1), BodyKind::rigid);
}

/// Awake: what stands is to stand by itself.
CaseScene floor_scene(double friction_angle, double half_width) {
  CaseScene scene = rock_scene(friction_angle);
  scene.project.solver.sleep_tolerance = 0;
  scene.add_fixed_box("floor", Vec3(-half_width, -half_width, -1), Vec3(half_width, half_width, 0));
  return scene;
}

/// Contacts of 10 E/h bear the lean of a column of 50 a hundred times over.
HardCase column(int count, BodyKind body) {
  return {.name = "column_of_" + std::to_string(count),
          .group = crowd_group,
          .title = "Column of " + std::to_string(count) + " cubes",
          .expected = {all_rest(0, 1e-6)},
          .build = [=] {
            CaseScene scene = floor_scene(30, 3);
            const int cells = body == BodyKind::rigid ? 1 : 2;
            for (int k = 0; k < count; ++k)
              scene.add_block("cube " + std::to_string(k + 1),
                              box_mesh(Vec3(-0.5, -0.5, k), Vec3(0.5, 0.5, k + 1), cells, cells, cells), body);
            scene.project.stages = {static_stage(0.1, 200), dynamic_stage(2e-3, 1)};
            return scene;
          }};
}

/// Each block on two of the row below.
HardCase pyramid(int courses) {
  return {.name = "pyramid_of_" + std::to_string(courses),
          .group = crowd_group,
          .title = "Pyramid of " + std::to_string(courses) + " courses of blocks",
          .expected = {all_rest(0, 1e-6)},
          .build = [=] {
            CaseScene scene = floor_scene(35, courses + 2.0);
            for (int k = 0; k < courses; ++k)
              for (int i = 0; i < courses - k; ++i) {
                const double x = i - 0.5 * (courses - k);
                add_rigid_box(scene, Vec3(x, -0.25, 0.5 * k), Vec3(x + 1, 0.25, 0.5 * (k + 1)));
              }
            scene.project.stages = {static_stage(0.05, 100), dynamic_stage(2e-3, 1)};
            return scene;
          }};
}

/// Stones of 0.6 to 1.4 m, each beginning elsewhere than those below: every centroid lies above what bears it.
HardCase dry_stone_wall(int courses, double length) {
  return {.name = "dry_stone_wall_of_" + std::to_string(courses),
          .group = crowd_group,
          .title = "Dry-stone wall of " + std::to_string(courses) + " courses",
          .takes_long = courses > 4,
          .expected = {all_rest(0, 1e-6)},
          .build = [=] {
            CaseScene scene = floor_scene(35, length + 2);
            double level = 0;
            for (int k = 0; k < courses; ++k) {
              const double height = 0.3 + 0.05 * (k * 2 % 3);
              int stone = k * 5;
              for (double x = 0, next = 0; x < length; x = next) {
                next = x + 0.6 + 0.2 * (stone++ * 3 % 5);
                if (next > length - 0.6) next = length;
                add_rigid_box(scene, Vec3(x, 0, level), Vec3(next, 0.5, level + height));
              }
              level += height;
            }
            scene.project.stages = {static_stage(0.05, 100), dynamic_stage(2e-3, 1)};
            return scene;
          }};
}

/// Each strikes the next where it leans by 30°, far past the 8.5° from which it falls by itself.
HardCase domino_row(int count) {
  constexpr double thickness = 0.15, pitch = 0.65, push = 3;  // m, m, rad/s about the lower front edge
  std::vector<HardCaseExpectation> expectations{stays_before(Vec3::Zero(), Vec3::UnitZ())};
  for (int i = 1; i <= count; ++i) expectations.push_back(topples("domino " + std::to_string(i), 30));
  return {.name = "domino_row_" + std::to_string(count),
          .group = crowd_group,
          .title = "Row of " + std::to_string(count) + " dominoes falls",
          .takes_long = count > 10,
          .expected = expectations,
          .build = [=] {
            CaseScene scene = floor_scene(40, count * pitch + 3);
            for (int i = 0; i < count; ++i)
              scene.add_block("domino " + std::to_string(i + 1),
                              box_mesh({i * pitch, -0.2, 0}, {i * pitch + thickness, 0.2, 1}, 1, 1, 1),
                              BodyKind::rigid);
            scene.project.velocities = {{.block = "domino 1",
                                         .linear = Vec3(0, push, 0).cross(Vec3(-thickness / 2, 0, 0.5)),
                                         .angular = {0, push, 0}}};
            scene.project.stages = {dynamic_stage(1e-3, 1 + 0.3 * count)};
            return scene;
          }};
}

constexpr double bedding = 20;  // degrees, of the joint set that blocks rest on; the others are vertical

/// A slope cut by three joint sets, of `side` blocks each way: columns of blocks on a bedding plane that dips along x.
CaseScene jointed_slope(int side, double friction_angle) {
  CaseScene scene = rock_scene(friction_angle);
  const Vec3 along(1, 0, -std::tan(radians(bedding))), across(0.3, 1, -0.3 * std::tan(radians(bedding)));
  const auto add = [&](const std::string& name, const Vec3& from, const Vec3& to, BodyKind body) {
    std::array<Vec3, 8> corners;
    for (int k = 0; k < 8; ++k)
      corners[k] =
          (k & 1 ? to : from).x() * along + (k & 2 ? to : from).y() * across + (k & 4 ? to : from).z() * Vec3::UnitZ();
    scene.add_block(name, hexahedron_mesh(corners, 1, 1, 1), body);
  };
  add("bedrock", Vec3(-1, -1, -2), Vec3(side + 10, side + 1, 0), BodyKind::fixed);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      for (int k = 0; k < side; ++k)
        add("block " + std::to_string((i * side + j) * side + k + 1), Vec3(i, j, k), Vec3(i + 1, j + 1, k + 1),
            BodyKind::rigid);
  return scene;
}

HardCase standing_slope(int side) {
  const std::string count = std::to_string(side * side * side);
  return {.name = "slope_of_" + count + "_stands",
          .group = crowd_group,
          .title = "Slope cut by three joint sets into " + count + " blocks, bedding 20°, friction 35°",
          .takes_long = side > 5,
          .expected = {all_rest(0, 1e-6)},
          .build = [=] {
            CaseScene scene = jointed_slope(side, 35);
            scene.project.stages = {static_stage(0.05, 100), dynamic_stage(2e-3, 0.5)};
            return scene;
          }};
}

constexpr double slippery = 10, sliding_time = 1;  // degrees, s

Vec3 down_the_bedding() { return {std::cos(radians(bedding)), 0, -std::sin(radians(bedding))}; }
Vec3 off_the_bedding() { return {std::sin(radians(bedding)), 0, std::cos(radians(bedding))}; }

/// How far a single body slides in that time [m].
double distance_of_single_body() {
  const double drive = std::sin(radians(bedding)) - std::tan(radians(slippery)) * std::cos(radians(bedding));
  return 9.81 * drive * sliding_time * sliding_time / 2;
}

/// Whatever blocks do among themselves: while all that touches the bedrock slides down it, friction is tan φ of what
/// presses, and twice integrated over time the momentum balance of the crowd's mean displacement u reads
/// u·down + tan φ u·up = g (sin α − tan φ cos α) t²/2.
HardCaseExpectation slides_as_a_crowd() {
  const double expected = distance_of_single_body();
  const Vec3 direction = down_the_bedding() + std::tan(radians(slippery)) * off_the_bedding();
  return {
      "the mean displacement down the slope, with tan φ of that off it, is " + significant(expected) + " m within 1 %",
      [=](const Trajectory& trajectory) {
        const double mean = mean_displacement(trajectory).dot(direction);
        return std::abs(mean - expected) < 0.01 * expected ? std::string() : "it is " + significant(mean) + " m";
      }};
}

/// With 10° all goes down on the lowest plane. A sliding column of cubes is pushed at 10° off its axis, so that one of
/// more than 1/tan 10° = 5.7 cubes tilts back against the slope: up to then the crowd goes as one, and higher it comes
/// apart.
HardCase sliding_slope(int side) {
  const std::string count = std::to_string(side * side * side), last = "block " + count;
  std::vector<HardCaseExpectation> expectations{slides_as_a_crowd(), stays_before(Vec3::Zero(), off_the_bedding())};
  if (side < 1 / std::tan(radians(slippery)))
    for (const std::string& block : {std::string("block 1"), last})
      expectations.push_back(travels(block, down_the_bedding(), distance_of_single_body(), 0.01));
  return {.name = "slope_of_" + count + "_slides",
          .group = crowd_group,
          .title = "Slope cut by three joint sets into " + count + " blocks, bedding 20°, friction 10°",
          .takes_long = side > 3,
          .expected = expectations,
          .build = [=] {
            CaseScene scene = jointed_slope(side, slippery);
            scene.project.stages = {dynamic_stage(2e-3, sliding_time)};
            return scene;
          }};
}

}  // namespace

std::vector<HardCase> standing_crowds() {
  return {column(10, BodyKind::tetrahedra),
          column(50, BodyKind::rigid),
          pyramid(4),
          pyramid(10),
          dry_stone_wall(4, 4),
          dry_stone_wall(10, 8),
          domino_row(5),
          domino_row(20),
          standing_slope(3),
          standing_slope(10),
          sliding_slope(3),
          sliding_slope(5),
          sliding_slope(7),
          sliding_slope(10)};
}

std::vector<HardCase> crowd_scenes() {
  std::vector<HardCase> all = standing_crowds(), piles = crowds_in_pits();
  std::move(piles.begin(), piles.end(), std::back_inserter(all));
  return all;
}

}  // namespace talus
