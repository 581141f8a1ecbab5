#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/structured_mesh.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/shapes.hpp"
#include "verification/random/families.hpp"
#include "verification/random/node_laws.hpp"
#include "verification/random/random_parts.hpp"

// Several bodies that touch in many places: linked, shaken.
namespace talus {

namespace {

constexpr double sinking_share = 0.1;  // of the thickness

/// How high above its middle the hole of such a ring is at a distance from the vertical through it [m].
double hole_height(double inner, int sides, double aside) {
  const double flat = inner * std::cos(std::numbers::pi / sides);
  double height = flat;
  for (int k = 1; 4 * k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    height = std::min(height, (flat - aside * std::sin(angle)) / std::cos(angle));
  }
  return height;
}

}  // namespace

HardCase random_chain(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  const int links = numbers.whole(2, 4), sides = 4 * numbers.whole(2, 5);
  const double inner = numbers.logarithmic(0.05, 1), thickness = inner * numbers.between(0.15, 0.5);
  // Bars lie on each other, across, where both rise or fall beside the middle: at their rims.
  const double pitch = 2 * hole_height(inner, sides, thickness / 2);
  CaseScene scene = random_rock_scene(numbers, numbers.between(0, 45));
  const TetMesh link = ring(inner, thickness, sides);
  for (int k = 0; k < links; ++k)
    scene.add_block("link " + std::to_string(k + 1),
                    placed(link, turn_about(Vec3::UnitZ(), k % 2 ? 90 : 0), {0, 0, -pitch * k}),
                    k == 0 ? BodyKind::fixed : draw.body());
  const double step = numbers.logarithmic(1e-3, 1e-2);
  scene.project.stages = {static_stage(step, 20), dynamic_stage(step, 100 * step)};
  place_scene(scene, turn_about(Vec3::UnitZ(), numbers.between(0, 360)), Vec3::Zero());
  HardCase drawn;
  drawn.title = std::to_string(links) + " rings of " + std::to_string(sides) + " pieces, " + significant(inner) +
                " m, " + draw.bodies_word() + ", steps of " + significant(step) + " s";
  drawn.expected = {all_rest(-1, 0.2 * inner, 181)};
  drawn.build = [scene] { return scene; };
  return drawn;
}

HardCase random_shaking(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  const int count = numbers.whole(1, 4);
  const double size = numbers.logarithmic(0.1, 2), amplitude = size * numbers.logarithmic(1e-3, 0.1);
  const double frequency = numbers.logarithmic(0.5, 10);  // Hz
  const double half = 4 * size + 2 * amplitude;
  CaseScene scene = random_rock_scene(numbers, numbers.between(5, 50));
  scene.add_fixed_box("table", {-half, -half, -size}, {half, half, 0});
  double z = 0;
  for (int k = 0; k < count; ++k) {
    const Vec3 box = size * Vec3(numbers.between(0.7, 1), numbers.between(0.7, 1), numbers.between(0.2, 0.6));
    const Vec3 corner(-box.x() / 2, -box.y() / 2, z);
    scene.add_block("box " + std::to_string(k + 1), box_mesh(corner, corner + box, 1, 1, 1), draw.body());
    z += box.z();
  }
  const Vec3 direction = Vec3(numbers.direction().cwiseProduct(Vec3(1, 1, 0.5)));
  const double step = numbers.logarithmic(1e-3, 1e-2), seconds = std::min(1.0, 200 * step);
  Constraint motion{.block = "table", .at = {}};
  for (int row = 0; row <= 200; ++row) {
    const double time = seconds * row / 200;
    motion.table.push_back({time, amplitude * std::sin(2 * std::numbers::pi * frequency * time) * direction});
  }
  scene.project.constraints = {motion};
  scene.project.stages = {dynamic_stage(step, seconds)};
  HardCase drawn;
  drawn.title = std::to_string(count) + " boxes of " + significant(size) + " m, " + draw.bodies_word() +
                ", on a table moved by " + significant(amplitude) + " m at " + significant(frequency) +
                " Hz, steps of " + significant(step) + " s";
  drawn.keeps_nodes = true;
  for (int k = 0; k < count; ++k)
    drawn.expected.push_back(nodes_stay_before("box " + std::to_string(k + 1), {0, 0, -amplitude}, Vec3::UnitZ(),
                                               sinking_share * 0.2 * size));
  drawn.build = [scene] { return scene; };
  return drawn;
}

}  // namespace talus
