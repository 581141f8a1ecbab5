#include <algorithm>
#include <cmath>

#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/shapes.hpp"
#include "verification/random/families.hpp"
#include "verification/random/node_laws.hpp"
#include "verification/random/random_parts.hpp"
#include "verification/random/rough_bed.hpp"

namespace talus {

namespace {

constexpr int bed_cells = 12;                 // each way
constexpr double most_in_the_bed = 0.1;       // of the thinnest body
constexpr double start_pitch = 1.1;           // diameters, from one body up to the next
constexpr double ground_gravity = 9.81;       // m/s²
constexpr double shortest_bed_step = 2.5e-4;  // s

}  // namespace

HardCase random_terrain(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  const int count = numbers.whole(1, 3);
  const double radius = numbers.logarithmic(0.05, 1), cell = radius * numbers.logarithmic(0.5, 3);
  const double roughness = cell * numbers.between(0.05, 0.5), dip = numbers.between(0, 40);
  const RoughBed bed(numbers, bed_cells, cell, roughness, dip);
  const double friction = numbers.between(5, 50), drop = radius * numbers.logarithmic(0.01, 5);
  CaseScene scene = random_rock_scene(numbers, friction);
  if (numbers.chance(0.3)) scene.project.joints[0].restitution = numbers.between(0, 1);
  scene.add_block("bed", bed.mesh(4 * radius), BodyKind::fixed);
  const double clear = bed.highest_within(2 * radius);
  double thinnest = radius, top = clear + drop;
  for (int k = 0; k < count; ++k) {
    RandomShape shape = random_shape(numbers, 1, true);
    for (Vec3& node : shape.mesh.nodes) node *= radius / shape.radius;
    thinnest = std::min(thinnest, radius / shape.radius);
    const Vec3 aside = radius * Vec3(numbers.between(-1, 1), numbers.between(-1, 1), 0);
    // One above the other, clear of the bed and of each other.
    const Vec3 place = aside + Vec3(0, 0, top + radius);
    top += 2 * start_pitch * radius;
    const std::string name = "body " + std::to_string(k + 1);
    scene.add_block(name, placed(shape.mesh, numbers.turn(), place), draw.body());
    scene.project.velocities.push_back({.block = name, .linear = numbers.between(0, 2) * numbers.direction()});
  }
  const double falling = std::sqrt(2 * (top - clear + 2 * roughness) / ground_gravity);
  const double seconds = falling + numbers.between(0.1, 0.5);
  const double step = std::max({shortest_bed_step, seconds / 250, numbers.logarithmic(5e-4, 5e-3)});
  scene.project.stages = {dynamic_stage(step, seconds)};
  HardCase drawn;
  drawn.title = std::to_string(count) + " bodies of " + significant(radius) + " m, " + draw.bodies_word() +
                ", fall by " + significant(drop) + " m on a bed that dips by " + significant(dip) + "°, cells of " +
                significant(cell) + " m rough by " + significant(roughness) + " m, friction " + significant(friction) +
                "°, steps of " + significant(step) + " s";
  drawn.keeps_nodes = true;
  drawn.expected = {nodes_stay_above(
      "the bed", [bed](const Vec3& point) { return bed.depth(point); }, most_in_the_bed * thinnest)};
  drawn.build = [scene] { return scene; };
  return drawn;
}

}  // namespace talus
