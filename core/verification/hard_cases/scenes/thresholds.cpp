#include <cmath>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/scenes/scene_groups.hpp"

// Pairs of scenes on both sides of the point where a block begins to slide, or a column to topple: as far apart as the
// pair says, half of that on either side.
namespace talus {

namespace {

const std::string threshold_group = "thresholds";

struct Pair {
  std::string name;  ///< for the scenes' names
  double apart;      ///< degrees
};
const Pair pairs[] = {{"1_degree", 1}, {"tenth_degree", 0.1}};

constexpr double incline_dip = 30;  // degrees, of the incline
constexpr double sliding = 2;       // s

CaseScene block_on_incline(double friction_angle, BodyKind body) {
  CaseScene scene = rock_scene(friction_angle);
  tilt(scene, incline_dip);
  scene.add_fixed_box("slab", Vec3(-4, -3, -1), Vec3(8, 3, 0));
  scene.add_box("block", Vec3(0, -0.5, 0), Vec3(1, 0.5, 1));
  scene.system.blocks.back().body = body;
  scene.project.solver.sleep_tolerance = 0;  // friction is to hold it, not sleep
  scene.project.stages = {static_stage(1e-3, 20), dynamic_stage(0.01, sliding / 2), dynamic_stage(0.01, sliding / 2)};
  return scene;
}

/// Distance slid by Coulomb's rigid block [m].
double sliding_distance(double friction_angle) {
  return 9.81 * std::sin(radians(incline_dip - friction_angle)) / std::cos(radians(friction_angle)) * sliding *
         sliding / 2;
}

/// What sticks yields elastically, in the block by ρ g sin α h²/2G = 3.2e-7 m and in the joint by W sin α/kA =
/// 5e-8 m, and then not any more. What slides is rigid: an elastic block starts with the speed of that rebound on top.
HardCase incline(const Pair& pair, bool slides, BodyKind body) {
  const double friction_angle = incline_dip + (slides ? -0.5 : 0.5) * pair.apart;
  std::vector<HardCaseExpectation> expectations = {rests("block", 0, 5e-7), rests("block", 1, 1e-9)};
  if (slides) expectations = {travels("block", Vec3(1, 0, 0), sliding_distance(friction_angle), 1e-3)};
  const std::string kind = body == BodyKind::rigid ? "rigid" : "elastic";
  return {.name = "incline_" + pair.name + (slides ? "_slides" : "_sticks_" + kind),
          .group = threshold_group,
          .title =
              "Block on 30°, " + kind + ", friction " + significant(pair.apart / 2) + "° " + (slides ? "less" : "more"),
          .expected = expectations,
          .build = [=] { return block_on_incline(friction_angle, body); }};
}

constexpr double column_width = 0.25, column_height = 1;  // m, of the column

CaseScene column_on_slab(double slab_dip, double duration) {
  CaseScene scene = rock_scene(35);
  tilt(scene, slab_dip);
  scene.add_fixed_box("slab", Vec3(-2, -1, -1), Vec3(3, 1, 0));
  scene.add_box("column", Vec3(0, -0.25, 0), Vec3(column_width, 0.25, column_height));
  scene.project.solver.sleep_tolerance = 0;
  scene.project.stages = {static_stage(1e-3, 20), dynamic_stage(0.005, duration / 2),
                          dynamic_stage(0.005, duration / 2)};
  return scene;
}

/// A rigid column that leans by ε beyond equilibrium over its toe turns by ε (cosh λt − 1), λ² = mgR/I = 14.3/s².
double turning_time(double beyond, double angle) {
  const double reach = std::hypot(column_width, column_height) / 2, inertia = 4 * reach * reach / 3;
  return std::acosh(1 + angle / beyond) / std::sqrt(9.81 * reach / inertia);
}

HardCase column(const Pair& pair, bool topples_over) {
  const double slab_dip = degrees(std::atan(column_width / column_height)) + (topples_over ? 0.5 : -0.5) * pair.apart;
  const double duration = turning_time(pair.apart / 2, 10);
  // The toe yields by W over the stiffness of half the base, 1e-7 m. It yields a little while the column tips: half
  // of the rigid column's 10° are asked for.
  std::vector<HardCaseExpectation> expectations = {rests("column", 0, 1e-6), rests("column", 1, 1e-9)};
  if (topples_over) expectations = {topples("column", 5)};
  return {.name = "column_" + pair.name + (topples_over ? "_topples" : "_stands"),
          .group = threshold_group,
          .title = "Column 4:1, slab " + significant(pair.apart / 2) + "° " + (topples_over ? "above" : "below") +
                   " the dip at which it topples",
          .expected = expectations,
          .build = [=] { return column_on_slab(slab_dip, duration); }};
}

}  // namespace

std::vector<HardCase> threshold_scenes() {
  std::vector<HardCase> scenes;
  for (const Pair& pair : pairs) {
    scenes.push_back(incline(pair, true, BodyKind::rigid));
    scenes.push_back(incline(pair, false, BodyKind::rigid));
    scenes.push_back(incline(pair, false, BodyKind::tetrahedra));
  }
  for (const Pair& pair : pairs)
    for (const bool topples_over : {true, false}) scenes.push_back(column(pair, topples_over));
  return scenes;
}

}  // namespace talus
