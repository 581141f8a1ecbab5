#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/shapes.hpp"
#include "verification/random/families.hpp"
#include "verification/random/node_laws.hpp"
#include "verification/random/random_parts.hpp"

namespace talus {

namespace {

/// A body may give way by a tenth of its own thickness when it strikes; what is deeper is on its way through.
constexpr double most_sinking = 0.1;
/// Whoever flies on has the velocity it had, but for rounding; what strikes obliquely loses at least the part of it
/// along the normal, a quarter.
constexpr double least_change = 0.01;

enum class Obstacle { wall, floor, edge };

std::string obstacle_word(Obstacle obstacle) {
  switch (obstacle) {
    case Obstacle::wall:
      return "a wall";
    case Obstacle::floor:
      return "a floor";
    case Obstacle::edge:
      break;
  }
  return "an edge";
}

/// A body that flies at what is fixed, in a frame in which that lies below z = 0 and the body above.
struct Impact {
  explicit Impact(SceneNumbers& numbers)
      : obstacle(numbers.one_of(std::vector{Obstacle::wall, Obstacle::floor, Obstacle::edge})),
        shape(random_shape(numbers, numbers.logarithmic(1e-3, 1), true)),
        turn(numbers.turn()),
        // The longest step and most_steps on its way let it come as far as it is long.
        speed(numbers.logarithmic(std::max(1.0, 8 * shape.radius / (most_steps * longest_step)), 50)),
        // The flanks of an edge fall away by 45°.
        incidence(numbers.between(0, obstacle == Obstacle::edge ? 25 : 75)),
        step(numbers.logarithmic(std::max(shortest_step, 2 * shape.radius / (most_steps * approach())), longest_step)),
        friction_angle(numbers.between(0, 60)) {
    const double way = approach() * step;
    const double gap = numbers.between(0, 1) * std::min(shape.radius + way, 30 * way);
    steps = static_cast<int>(std::ceil((gap + 2 * shape.radius) / way)) + 20;
    double lowest = 0;
    for (const Vec3& node : shape.mesh.nodes) lowest = std::min(lowest, (turn * node).z());
    height = gap - lowest;
    // At most a rim as fast as the body, and a radian a step.
    if (numbers.chance(0.5)) spin = numbers.between(0, 1) * std::min(speed / shape.radius, 1 / step);
    // What pulls does not keep it from where it flies: along a wall, or onto a floor.
    if (obstacle == Obstacle::floor) gravity = -9.81 * Vec3::UnitZ();
    if (obstacle == Obstacle::wall && numbers.chance(0.5)) gravity = 9.81 * Vec3::UnitX();
  }

  double approach() const { return speed * std::cos(radians(incidence)); }  // m/s
  /// Along +x or −x too, by chance of the turn of the whole scene.
  Vec3 velocity() const { return {speed * std::sin(radians(incidence)), 0, -approach()}; }
  /// Of the centroid, which flies at the origin: the ridge, where there is one.
  Vec3 start() const { return velocity() * (height / velocity().z()); }
  double seconds() const { return steps * step; }
  /// How far it may come, however it is thrown aside [m].
  double reach() const {
    return 2 * start().norm() + 2 * (speed + gravity.norm() * seconds()) * seconds() + 3 * shape.radius;
  }

  static constexpr double shortest_step = 1e-4, longest_step = 2e-2;  // s
  static constexpr double most_steps = 200;                           // for twice its radius

  Obstacle obstacle;
  RandomShape shape;
  Mat3 turn;
  double speed, incidence;      // m/s, degrees from the normal
  double step, friction_angle;  // s, degrees
  int steps = 0;
  double height = 0, spin = 0;  // m, of the centroid; rad/s
  Vec3 gravity = Vec3::Zero();  // m/s²
};

/// As wide as the body may come, and so thick that it is no plate beside it.
void add_obstacle(CaseScene& scene, const Impact& impact) {
  const double half = impact.reach();
  if (impact.obstacle != Obstacle::edge) {
    scene.add_fixed_box("obstacle", {-half, -half, -half}, {half, half, 0});
    return;
  }
  // A roof whose ridge, a right angle, is the y axis.
  scene.add_block("obstacle", placed(wedge(2 * half, 2 * half, half), {0, 0, -half}), BodyKind::fixed);
}

std::string title_of(const Impact& impact, const std::string& body) {
  return impact.shape.word + " of " + significant(impact.shape.thickness) + " m, " + body + ", at " +
         obstacle_word(impact.obstacle) + " with " + significant(impact.speed) + " m/s, " +
         significant(impact.incidence) + "° off the normal, " + significant(impact.spin) + " rad/s, steps of " +
         significant(impact.step) + " s";
}

}  // namespace

HardCase random_impact(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  const Impact impact(numbers);
  CaseScene scene = random_rock_scene(numbers, impact.friction_angle);
  if (numbers.chance(0.3)) scene.project.joints[0].restitution = numbers.between(0, 1);
  add_obstacle(scene, impact);
  const BodyKind body = draw.body();
  add_random_block(scene, "body", impact.shape, body, impact.turn, impact.start(), numbers);
  scene.project.velocities = {
      {.block = "body", .linear = impact.velocity(), .angular = impact.spin * numbers.direction()}};
  scene.project.gravity = impact.gravity;
  scene.project.stages = {dynamic_stage(impact.step, impact.seconds())};
  // A floor lies flat; a wall and an edge look anywhere.
  const Mat3 turn =
      impact.obstacle == Obstacle::floor ? turn_about(Vec3::UnitZ(), numbers.between(0, 360)) : numbers.turn();
  place_scene(scene, turn, Vec3::Zero());
  HardCase drawn;
  drawn.title = title_of(impact, std::string(to_string(body)));
  drawn.keeps_nodes = true;
  drawn.expected = {is_turned_away("body", scene.project.gravity, least_change)};
  if (impact.obstacle != Obstacle::edge)
    drawn.expected.push_back(
        nodes_stay_before("body", Vec3::Zero(), turn * Vec3::UnitZ(), most_sinking * impact.shape.thickness));
  drawn.build = [scene] { return scene; };
  return drawn;
}

}  // namespace talus
