#include <cmath>

#include "base/units.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/classic/classic_scenes.hpp"

namespace talus {

namespace {

constexpr double card_length = 1, card_width = 0.6, thick = 0.03, slope = 65;  // m, m, m, degrees

/// Pairs of cards that lean on each other, tip to tip, and flat ones across the tips that carry the next level. The
/// feet of a pair stand just within the tips below.
class CardHouse {
 public:
  CardHouse(CaseScene& scene, int levels) : scene_(scene) {
    double floor = 0;
    for (int level = 0; level < levels; ++level) {
      const int pairs = levels - level;
      for (int i = 0; i < pairs; ++i) add_pair((i - 0.5 * (pairs - 1)) * pitch, floor);
      floor += rise;
      for (int i = 0; i + 1 < pairs; ++i) add_flat((i - 0.5 * (pairs - 2)) * pitch, floor);
      floor += thick;
    }
  }

 private:
  static inline const double half_span = card_length * std::cos(radians(slope));
  static inline const double rise = card_length * std::sin(radians(slope)) + thick * std::cos(radians(slope));
  static inline const double pitch = 2 * half_span + 2 * thick;
  static constexpr double gap = 0.01;  // m, between flat cards of a level

  /// The inner edges of their upper ends touch, their lower faces' edges stand on the floor.
  void add_pair(double middle, double floor) {
    const TetMesh card = box_mesh({0, -card_width / 2, 0}, {card_length, card_width / 2, thick}, 4, 2, 1);
    const Mat3 lean = turn_about(-Vec3::UnitY(), slope), mirror = Vec3(-1, -1, 1).asDiagonal();  // a half turn about z
    add_card(placed(placed(card, lean, {-half_span, 0, 0}), {middle, 0, floor}));
    add_card(placed(placed(card, mirror * lean, {half_span, 0, 0}), {middle, 0, floor}));
  }
  void add_flat(double middle, double floor) {
    const double half = (pitch - gap) / 2;
    add_card(
        box_mesh({middle - half, -card_width / 2, floor}, {middle + half, card_width / 2, floor + thick}, 4, 2, 1));
  }
  void add_card(TetMesh mesh) {
    scene_.add_block("card " + std::to_string(++cards_), std::move(mesh), BodyKind::rigid);
  }

  CaseScene& scene_;
  int cards_ = 0;
};

CaseScene house_scene(int levels, bool hit) {
  CaseScene scene = scene_of(hard_stone(), 0.5);
  scene.add_fixed_box("floor", {-8, -3, -1}, {8, 3, 0});
  CardHouse(scene, levels);
  scene.project.stages = {static_stage(0.005, 100), dynamic_stage(0.002, 2)};
  if (hit) {
    scene.add_block("cube", placed(cube(0.4), {-levels * 0.6 - 0.4, 0, 0.6}), BodyKind::rigid);
    scene.project.velocities = {{.block = "cube", .linear = {5, 0, 0}}};
    scene.project.stages.erase(scene.project.stages.begin());
  }
  return scene;
}

std::string levels_text(int levels) { return std::to_string(levels) + " levels"; }

/// Feet press outwards by cot 65° = 0.47 of what they bear at most, less than μ.
HardCase standing_house(int levels) {
  return {.name = "card_house_" + std::to_string(levels),
          .group = classic_group,
          .title = "Card house of " + levels_text(levels) + ", 65°, μ 0.5",
          .source = "Ferguson et al. 2021 (rigid IPC)",
          .expected = {all_rest(0, 1e-6)},
          .build = [=] { return house_scene(levels, false); }};
}

/// A cube of half the house's mass at 5 m/s; the last card is one of the topmost pair.
HardCase hit_house(int levels) {
  const int cards = levels * (levels + 1) + levels * (levels - 1) / 2;
  return {.name = "card_house_" + std::to_string(levels) + "_hit",
          .group = classic_group,
          .title = "Card house of " + levels_text(levels) + " hit by a cube at 5 m/s",
          .source = "Ferguson et al. 2021 (rigid IPC)",
          .takes_long = levels > 2,
          .expected = {travels_at_least("card " + std::to_string(cards), -Vec3::UnitZ(), 0.3),
                       stays_before(Vec3::Zero(), Vec3::UnitZ())},
          .build = [=] { return house_scene(levels, true); }};
}

}  // namespace

std::vector<HardCase> card_house_scenes() {
  return {standing_house(2), standing_house(3), standing_house(4), hit_house(2), hit_house(3), hit_house(4)};
}

}  // namespace talus
