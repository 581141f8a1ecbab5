#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/hard_cases/shapes.hpp"
#include "verification/random/families.hpp"
#include "verification/random/random_parts.hpp"

// What stands on its own base, or does not: columns, towers, unequal boxes, boxes that nearly coincide.
namespace talus {

namespace {

constexpr double pull = 9.81;           // m/s²
constexpr double unrest_share = 1e-6;   // of the size
constexpr double settling_step = 0.01;  // s

/// A box that stands at z, as finely meshed as its body needs.
void add_standing_box(CaseScene& scene, const std::string& name, const Vec3& foot, const Vec3& size, BodyKind body,
                      int material = 0) {
  const int cells = body == BodyKind::tetrahedra ? 2 : 1;
  const Vec3 half(size.x() / 2, size.y() / 2, 0);
  scene.add_block(name, box_mesh(foot - half, foot + half + Vec3(0, 0, size.z()), cells, cells, 1), body, material);
}

/// They settle, and then rest by themselves for so long [s].
void let_rest(CaseScene& scene, double time_step, double seconds) {
  scene.project.solver.sleep_tolerance = 0;
  scene.project.stages = {settling_stage(settling_step), dynamic_stage(time_step, seconds)};
}

/// A rigid column that leans by ε beyond equilibrium over its toe turns by ε (cosh λt − 1), λ² = mgR/I [s].
double time_to_turn(double width, double height, double beyond, double angle) {
  const double reach = std::hypot(width, height) / 2, inertia = 4 * reach * reach / 3;
  return std::acosh(1 + angle / beyond) / std::sqrt(pull * reach / inertia);
}

/// A box of a tower.
struct Storey {
  Vec3 size, foot;
};

/// Where the weight of all above the storey lies within what bears it, by a tenth of that at least.
bool bears(const std::vector<Storey>& tower, std::size_t storey) {
  Vec3 middle = Vec3::Zero();
  double volume = 0;
  for (std::size_t k = storey + 1; k < tower.size(); ++k) {
    middle += tower[k].size.prod() * tower[k].foot;
    volume += tower[k].size.prod();
  }
  middle /= volume;
  const Storey &below = tower[storey], &above = tower[storey + 1];
  for (int axis = 0; axis < 2; ++axis) {
    const double low = std::max(below.foot[axis] - below.size[axis] / 2, above.foot[axis] - above.size[axis] / 2);
    const double high = std::min(below.foot[axis] + below.size[axis] / 2, above.foot[axis] + above.size[axis] / 2);
    const double margin = 0.1 * (high - low);
    if (!(middle[axis] > low + margin && middle[axis] < high - margin)) return false;
  }
  return true;
}

std::vector<Storey> random_storeys(SceneNumbers& numbers) {
  const int count = numbers.whole(2, 7);
  const double size = numbers.logarithmic(0.1, 3);
  for (double skew = 0.5;; skew /= 2) {
    std::vector<Storey> tower;
    Vec3 foot = Vec3::Zero();
    for (int k = 0; k < count; ++k) {
      const Vec3 box = size * Vec3(numbers.between(0.5, 1.5), numbers.between(0.5, 1.5), numbers.between(0.2, 1));
      tower.push_back({box, foot});
      foot += Vec3(skew * box.x() * numbers.between(-1, 1), skew * box.y() * numbers.between(-1, 1), box.z());
    }
    bool stands = true;
    for (std::size_t k = 0; k + 1 < tower.size(); ++k) stands = stands && bears(tower, k);
    if (stands) return tower;
  }
}

}  // namespace

HardCase random_toppling(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  const double height = numbers.logarithmic(0.2, 5), width = height * numbers.between(0.1, 0.5);
  const double threshold = degrees(std::atan(width / height)), apart = numbers.logarithmic(0.05, 4);
  const bool tips = numbers.chance(0.5);
  const double dip = threshold + (tips ? apart : -apart), friction = dip + numbers.between(10, 40);
  CaseScene scene = random_rock_scene(numbers, friction);
  scene.project.materials[0].young = 5e10;  // so that its toe gives way by far less than the angle to the threshold
  const BodyKind body = draw.body();
  const double step = numbers.logarithmic(1e-3, 1e-2), depth = width * numbers.between(0.7, 2);
  scene.add_fixed_box("slab", {-2 * height, -2 * height, -height}, {3 * height, 2 * height, 0});
  add_standing_box(scene, "column", Vec3::Zero(), {width, depth, height}, body);
  if (tips) {
    scene.project.solver.sleep_tolerance = 0;
    scene.project.stages = {dynamic_stage(step, time_to_turn(width, height, apart, 10))};
  } else {
    let_rest(scene, step, 1);
  }
  const Site site(numbers);
  place_scene(scene, site.turn() * turn_about(Vec3::UnitY(), dip), site.shift);
  scene.project.gravity = -pull * Vec3::UnitZ();
  HardCase drawn;
  drawn.title = "column, " + std::string(to_string(body)) + ", of " + significant(width) + " by " +
                significant(height) + " m, dip " + significant(apart) + "° " + (tips ? "above" : "below") +
                " that at which it topples, " + site.words() + ", steps of " + significant(step) + " s";
  drawn.expected = {tips ? topples("column", 5) : rests("column", 0, unrest_share * height)};
  drawn.build = [scene] { return scene; };
  return drawn;
}

HardCase random_tower(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  const std::vector<Storey> tower = random_storeys(numbers);
  CaseScene scene = random_rock_scene(numbers, numbers.between(10, 60));
  double size = 0;
  for (const Storey& storey : tower) size = std::max(size, storey.size.maxCoeff());
  scene.add_fixed_box("floor", {-5 * size, -5 * size, -size}, {5 * size, 5 * size, 0});
  for (std::size_t k = 0; k < tower.size(); ++k)
    add_standing_box(scene, "box " + std::to_string(k + 1), tower[k].foot, tower[k].size, draw.body());
  const double step = numbers.logarithmic(1e-3, 1e-2);
  let_rest(scene, step, 0.5);
  const Site site(numbers);
  place_scene(scene, site.turn(), site.shift);
  HardCase drawn;
  drawn.title = std::to_string(tower.size()) + " boxes up to " + significant(size) + " m, " + draw.bodies_word() +
                ", " + site.words() + ", steps of " + significant(step) + " s";
  drawn.expected = {all_rest(0, unrest_share * size)};
  drawn.build = [scene] { return scene; };
  return drawn;
}

HardCase random_ratios(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  CaseScene scene = random_rock_scene(numbers, numbers.between(20, 50));
  Material other = scene.project.materials[0];
  const double densities = numbers.logarithmic(1e-4, 1), sizes = numbers.logarithmic(1e-3, 1);
  const bool light_above = numbers.chance(0.5), small_above = numbers.chance(0.7);
  other.name = "other";
  other.density *= densities;
  const int light = scene.add_material(other);
  // What is large stands on what is small only where that bears it: no smaller than a tenth.
  const double small = small_above ? sizes : std::max(sizes, 0.1);
  const double lower = small_above ? 1 : small, upper = small_above ? small : 1;
  scene.add_fixed_box("floor", {-4, -4, -1}, {4, 4, 0});
  add_standing_box(scene, "lower", Vec3::Zero(), Vec3::Constant(lower), draw.body(), light_above ? 0 : light);
  add_standing_box(scene, "upper", {0, 0, lower}, Vec3::Constant(upper), draw.body(), light_above ? light : 0);
  const double step = numbers.logarithmic(1e-3, 1e-2);
  let_rest(scene, step, 0.5);
  place_scene(scene, turn_about(Vec3::UnitZ(), numbers.between(0, 360)), Vec3::Zero());
  HardCase drawn;
  drawn.title = "cubes of densities 1 : " + significant(1 / densities) + ", the light one " +
                (light_above ? "above" : "below") + ", sizes " + significant(lower) + " and " + significant(upper) +
                " m, " + draw.bodies_word() + ", steps of " + significant(step) + " s";
  drawn.expected = {all_rest(0, unrest_share)};
  drawn.build = [scene] { return scene; };
  return drawn;
}

HardCase random_coincidence(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  CaseScene scene = random_rock_scene(numbers, numbers.between(20, 50));
  double largest = 0;
  // Nothing, or hardly anything.
  const auto miss = [&] {
    const double size = numbers.logarithmic(1e-12, 1e-3);
    const double drawn = numbers.chance(0.3) ? 0 : size;
    largest = std::max(largest, drawn);
    return drawn;
  };
  const auto sign = [&] { return numbers.chance(0.5) ? 1.0 : -1.0; };
  scene.add_fixed_box("floor", {-5, -5, -1}, {5, 5, 0});
  // Four in a square, and one on them whose edges lie above theirs, or whose corner lies above where they meet.
  // Those of the second row and column begin where the first, which stand askew, end at the latest.
  const double askew[2] = {miss(), miss()}, gaps[2] = {miss(), miss()};
  for (int k = 0; k < 4; ++k) {
    Vec3 place = Vec3::Zero();
    for (int axis = 0; axis < 2; ++axis)
      place[axis] = k & (1 << axis) ? 1 + askew[axis] + gaps[axis] : askew[axis] * (k == 0 ? 1 : 0);
    add_standing_box(scene, "box " + std::to_string(k + 1), place, Vec3::Ones(), draw.body());
  }
  const Vec3 foot = numbers.chance(0.5) ? Vec3(sign() * miss(), sign() * miss(), 1)
                                        : Vec3(0.5 + sign() * miss(), 0.5 + sign() * miss(), 1);
  add_standing_box(scene, "upper", foot, Vec3::Ones(), draw.body());
  const double step = numbers.logarithmic(1e-3, 1e-2);
  let_rest(scene, step, 0.5);
  HardCase drawn;
  drawn.title = "boxes that miss each other by up to " + significant(largest) + " m, " + draw.bodies_word() +
                ", steps of " + significant(step) + " s";
  drawn.expected = {all_rest(0, unrest_share)};
  drawn.build = [scene] { return scene; };
  return drawn;
}

}  // namespace talus
