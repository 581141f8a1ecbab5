#include <algorithm>
#include <cmath>

#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/shapes.hpp"
#include "verification/random/families.hpp"
#include "verification/random/node_laws.hpp"
#include "verification/random/random_parts.hpp"

// Bodies that fall onto each other in a closed box.
namespace talus {

namespace {

constexpr double most_outside = 0.1;  // of the thickness of the thinnest

/// A fixed slab on every side of the box. They touch; none lies in another.
void add_closed_box(CaseScene& scene, const Vec3& min, const Vec3& max, double wall) {
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 low = min, high = max;
    for (int before = 0; before < axis; ++before) {
      low[before] -= wall;
      high[before] += wall;
    }
    const double least = low[axis], most = high[axis];
    low[axis] = least - wall, high[axis] = least;
    scene.add_fixed_box("low " + std::to_string(axis + 1), low, high);
    low[axis] = most, high[axis] = most + wall;
    scene.add_fixed_box("high " + std::to_string(axis + 1), low, high);
  }
}

/// What is poured, one after the other, of thickness 1.
using ShapeDrawer = RandomShape (*)(SceneNumbers&);

HardCase pour_of(Draw& draw, ShapeDrawer next_shape, const std::string& what, int most_layers) {
  SceneNumbers& numbers = draw.numbers;
  const int across = 2, layers = numbers.whole(1, most_layers), count = across * across * layers;
  const double radius = numbers.logarithmic(0.05, 0.5), cell = 2.1 * radius;
  CaseScene scene = random_rock_scene(numbers, numbers.between(0, 50));
  const Vec3 low = Vec3::Zero(), high = cell * Vec3(across, across, layers + 0.5);
  add_closed_box(scene, low, high, 2 * radius);
  double thinnest = radius;
  for (int k = 0; k < count; ++k) {
    const RandomShape unit = next_shape(numbers);
    RandomShape shape = unit;
    for (Vec3& node : shape.mesh.nodes) node *= radius / unit.radius;
    thinnest = std::min(thinnest, radius / unit.radius);
    const Vec3 place = cell * Vec3(k % 2 + 0.5, k / 2 % 2 + 0.5, k / 4 + 0.5);
    const std::string name = "body " + std::to_string(k + 1);
    scene.add_block(name, placed(shape.mesh, numbers.turn(), place), draw.body());
    scene.project.velocities.push_back({.block = name, .linear = numbers.between(0, 3) * numbers.direction()});
  }
  const double step = numbers.logarithmic(5e-4, 5e-3);
  scene.project.stages = {dynamic_stage(step, std::min(0.5, 200 * step))};
  HardCase drawn;
  drawn.title = std::to_string(count) + ' ' + what + ", " + draw.bodies_word() + ", in a closed box of " +
                significant(high.x()) + " m, steps of " + significant(step) + " s";
  drawn.keeps_nodes = true;
  drawn.expected = {nodes_stay_in_box(low, high, most_outside * thinnest)};
  drawn.build = [scene] { return scene; };
  return drawn;
}

}  // namespace

HardCase random_pour(Draw& draw) {
  return pour_of(
      draw, [](SceneNumbers& numbers) { return random_shape(numbers, 1, true); }, "bodies", 2);
}

/// Rings have a hundred tetrahedra each: two layers of them, meshed, would take minutes.
HardCase random_tangle(Draw& draw) { return pour_of(draw, random_gripping_shape, "hooks, rings and chips", 1); }

}  // namespace talus
