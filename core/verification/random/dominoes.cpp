#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "mesh/structured_mesh.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/shapes.hpp"
#include "verification/random/families.hpp"
#include "verification/random/random_parts.hpp"
#include "verification/random/standing_dominoes.hpp"

// A row of dominoes whose first is given a spin about its lower front edge, beside that at which it tips over.
namespace talus {

namespace {

constexpr double domino_gravity = 9.81;  // m/s²

StandingDominoes random_row(SceneNumbers& numbers, double friction) {
  constexpr double share = 1.2;
  StandingDominoes row{numbers.whole(3, 6), numbers.logarithmic(0.05, 3), 0, 0};
  row.gap = row.height * numbers.between(0.35, 0.7);
  // The more slender, the easier.
  for (double slender = numbers.between(0.08, 0.25);; slender *= 0.9) {
    row.thickness = slender * row.height;
    if (row.leaning_overturns(friction, share)) return row;
  }
}

}  // namespace

HardCase random_dominoes(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  const double friction = numbers.between(30, 45);
  const StandingDominoes row = random_row(numbers, friction);
  const bool falls = numbers.chance(0.6);
  const double above = numbers.logarithmic(0.05, 0.5), share = falls ? 1 + above : 1 - above;
  CaseScene scene = random_rock_scene(numbers, friction);
  scene.project.solver.sleep_tolerance = 0;
  scene.project.materials[0].young = 5e10;  // so that edges give way by far less than they are turned about
  const double pitch = row.thickness + row.gap, end = row.count * pitch + 2 * row.height;
  scene.add_fixed_box("floor", {-2 * row.height, -2 * row.height, -row.height}, {end, 2 * row.height, 0});
  const double half_width = row.height * numbers.between(0.15, 0.4);
  for (int i = 0; i < row.count; ++i)
    scene.add_block("domino " + std::to_string(i + 1),
                    box_mesh({i * pitch, -half_width, 0}, {i * pitch + row.thickness, half_width, row.height}, 1, 1, 1),
                    draw.body());
  const Vec3 spin(0, share * row.tipping_spin(), 0), arm(-row.thickness / 2, 0, row.height / 2);
  scene.project.velocities = {{.block = "domino 1", .linear = spin.cross(arm), .angular = spin}};
  const double second = std::sqrt(row.height / domino_gravity), step = second * numbers.logarithmic(6e-3, 2e-2);
  // The first tarries at its highest, the longer the nearer it is to the threshold.
  const double seconds = second * (2 - std::log(above) + (falls ? 1.5 * row.count : 2));
  scene.project.stages = {dynamic_stage(step, seconds)};
  const Mat3 turn = turn_about(Vec3::UnitZ(), numbers.between(0, 360));
  place_scene(scene, turn, Vec3::Zero());
  HardCase drawn;
  drawn.title = std::to_string(row.count) + " dominoes of " + significant(row.thickness) + " by " +
                significant(row.height) + " m, " + draw.bodies_word() + ", " + significant(row.gap) +
                " m apart, friction " + significant(friction) + "°, the first with " + significant(share) +
                " of the spin that tips it, steps of " + significant(step) + " s";
  drawn.expected = {stays_before(Vec3::Zero(), Vec3::UnitZ())};
  for (int i = 1; i <= row.count; ++i) {
    const std::string name = "domino " + std::to_string(i);
    drawn.expected.push_back(falls ? topples(name, row.leaning_angle())
                                   : rests(name, -1, row.height, i == 1 ? row.tipping_angle() : 0.1));
  }
  drawn.build = [scene] { return scene; };
  return drawn;
}

}  // namespace talus
