#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/random/families.hpp"
#include "verification/random/node_laws.hpp"
#include "verification/random/random_parts.hpp"

namespace talus {

namespace {

constexpr double momentum_share = 1e-9;

/// A body on its way to the middle, where all arrive together.
struct Missile {
  RandomShape shape;
  Vec3 from;        ///< direction that it comes from
  double speed;     ///< m/s
  double spinning;  ///< rad/s
};

std::vector<Missile> random_missiles(SceneNumbers& numbers) {
  const int count = numbers.whole(2, 3);
  const double size = numbers.logarithmic(0.01, 1), speed = numbers.logarithmic(0.1, 30);
  const Vec3 axis = numbers.direction();
  std::vector<Missile> missiles;
  for (int i = 0; i < count; ++i) {
    RandomShape shape = random_shape(numbers, size * numbers.logarithmic(0.3, 1), true);
    // From all around, so that they lie nowhere in each other before.
    const double angle = 360.0 * (i + numbers.between(0, 0.3)) / count;
    const Vec3 across = axis.unitOrthogonal();
    const Vec3 from = std::cos(radians(angle)) * across + std::sin(radians(angle)) * axis.cross(across);
    const double own_speed = speed * numbers.between(0.3, 1);
    const double spinning = numbers.chance(0.5) ? numbers.between(0, 1) * own_speed / shape.radius : 0;
    missiles.push_back({std::move(shape), from, own_speed, spinning});
  }
  return missiles;
}

}  // namespace

HardCase random_collision(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  const std::vector<Missile> missiles = random_missiles(numbers);
  const double friction = numbers.between(0, 60);
  CaseScene scene = random_rock_scene(numbers, friction);
  scene.project.gravity.setZero();
  const double restitution = numbers.between(0, 1);
  const bool springs = numbers.chance(0.25);
  if (!springs) scene.project.joints[0].restitution = restitution;
  double radius = 0, slowest = missiles[0].speed;
  for (const Missile& missile : missiles) {
    radius = std::max(radius, missile.shape.radius);
    slowest = std::min(slowest, missile.speed);
  }
  std::string words;
  for (std::size_t i = 0; i < missiles.size(); ++i) {
    const Missile& missile = missiles[i];
    const std::string name = "body " + std::to_string(i + 1);
    const BodyKind body = draw.body();
    // Circles of two do not touch at 2.2 radii from the middle, those of three neither.
    const Vec3 start = 2.2 * radius * missile.from;
    const Vec3 aim = 0.5 * missile.shape.radius * numbers.between(0, 1) * numbers.direction();
    add_random_block(scene, name, missile.shape, body, numbers.turn(), start + aim, numbers);
    scene.project.velocities.push_back(
        {.block = name, .linear = -missile.speed * missile.from, .angular = missile.spinning * numbers.direction()});
    words += (words.empty() ? "" : ", ") + missile.shape.word + ' ' + std::string(to_string(body));
  }
  const double seconds = 2 * 2.2 * radius / slowest;
  const double step = seconds / numbers.logarithmic(30, 150);
  scene.project.stages = {dynamic_stage(step, seconds)};
  HardCase drawn;
  drawn.title = words + " fly at each other, restitution " + (springs ? "of springs" : significant(restitution)) +
                ", friction " + significant(friction) + "°, steps of " + significant(step) + " s";
  drawn.keeps_nodes = true;
  drawn.expected = {momentum_stays(scene.project.materials, momentum_share)};
  drawn.build = [scene] { return scene; };
  return drawn;
}

}  // namespace talus
