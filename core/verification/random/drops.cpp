#include <algorithm>
#include <cmath>

#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/shapes.hpp"
#include "verification/random/families.hpp"
#include "verification/random/node_laws.hpp"
#include "verification/random/random_parts.hpp"

namespace talus {

namespace {

constexpr double earth = 9.81;        // m/s²
constexpr double most_sagging = 0.1;  // of the thickness

/// A restitution of 0 and of 1 is as likely as all between.
double random_restitution(SceneNumbers& numbers) {
  const double between = numbers.between(0, 1);
  return numbers.chance(0.25) ? 1 : numbers.chance(0.1) ? 0 : between;
}

}  // namespace

HardCase random_drop(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  const RandomShape shape = random_shape(numbers, numbers.logarithmic(0.05, 1), false);
  const double height = numbers.logarithmic(0.01, 5), friction = numbers.between(0, 60);
  CaseScene scene = random_rock_scene(numbers, friction);
  const double restitution = random_restitution(numbers);
  scene.project.joints[0].restitution = restitution;
  const Mat3 turn = numbers.turn();
  double lowest = 0;
  for (const Vec3& node : shape.mesh.nodes) lowest = std::min(lowest, (turn * node).z());
  const double falling = std::sqrt(2 * height / earth), seconds = 2 * falling + numbers.between(0.1, 0.5);
  const double step = std::max(numbers.logarithmic(2e-4, 1e-2), seconds / 1000);
  const double half = 3 * shape.radius + 10 * height + 2;
  scene.add_fixed_box("floor", {-half, -half, -1 - shape.radius}, {half, half, 0});
  const BodyKind body = draw.body();
  add_random_block(scene, "body", shape, body, turn, {0, 0, height - lowest}, numbers);
  scene.project.stages = {dynamic_stage(step, seconds)};
  place_scene(scene, turn_about(Vec3::UnitZ(), numbers.between(0, 360)), Vec3::Zero());
  HardCase drawn;
  drawn.title = shape.word + " of " + significant(shape.thickness) + " m, " + std::string(to_string(body)) +
                ", dropped by " + significant(height) + " m, restitution " + significant(restitution) + ", friction " +
                significant(friction) + "°, steps of " + significant(step) + " s";
  drawn.keeps_nodes = true;
  drawn.expected = {nodes_stay_before("body", Vec3::Zero(), Vec3::UnitZ(), most_sagging * shape.thickness)};
  drawn.build = [scene] { return scene; };
  return drawn;
}

}  // namespace talus
