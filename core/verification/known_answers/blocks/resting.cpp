#include "verification/known_answers/blocks/block_cases.hpp"

#include <cmath>

#include "base/units.hpp"
#include "model/stages.hpp"
#include "verification/known_answers/support/bracket.hpp"
#include "verification/known_answers/support/recorded_run.hpp"

namespace talus {

namespace {

/// What stands or falls is told by whether a block goes this far [m] in blocks of 1 m.
constexpr double lid_moved = 1e-3;

CaseOutcome slope(const CaseOptions& options, Progress& progress) {
  CaseScene scene = rock_scene(30);
  scene.project.solver.sleep_tolerance = 0;  // friction is to hold the blocks, not sleep
  tilt(scene, 26.5);
  scene.add_fixed_box("slope", Vec3(-1, -1, -1), Vec3(9, 3, 0));
  for (int i = 0; i < 32; ++i) {
    const Vec3 corner(i % 8, i / 8 % 2, i / 16);
    scene.add_box("block " + std::to_string(i + 1), corner, corner + Vec3::Ones());
  }
  const int static_steps = 100;
  scene.project.stages = {static_stage(0.01, static_steps), dynamic_stage(0.01, 10)};
  const auto snapshots = record(scene, options, progress);
  CaseOutcome outcome;
  outcome.findings.push_back({.quantity = "creep in 10 s of the size, of any of 32 blocks",
                              .unit = "",
                              .computed = farthest(snapshots[static_steps], snapshots.back()),
                              .tolerance = 1e-9,
                              .absolute = true});
  return outcome;
}

/// Bricks of 1 m on a table that ends at x = 0; each brick overhangs the lower one by `share` of what would balance.
CaseScene overhanging_bricks(int count, double share) {
  const double length = 1, height = 0.2;
  CaseScene scene = rock_scene(30);
  scene.add_fixed_box("table", Vec3(-3, -1, -1), Vec3(0, 1, 0));
  double end = 0;
  for (int i = count; i >= 1; --i) {
    end += share * length / (2 * i);
    const double base = (count - i) * height;
    scene.add_box("brick " + std::to_string(i), Vec3(end - length, -0.25, base), Vec3(end, 0.25, base + height));
  }
  scene.project.stages = {static_stage(0.01, 50), dynamic_stage(0.01, 2)};
  return scene;
}

CaseOutcome overhang(const CaseOptions& options, Progress& progress) {
  const int count = 5;
  double harmonic = 0;
  for (int i = 1; i <= count; ++i) harmonic += 1.0 / i;
  const Bracket share = narrowed({1.02, 0.98}, options.thorough ? 6 : 3, [&](double trial) {
    return sets_off(overhanging_bricks(count, trial), lid_moved, options, progress);
  });
  CaseOutcome outcome;
  outcome.findings.push_back({.quantity = "largest overhang of 5 bricks of 1 m",
                              .unit = "m",
                              .expected = harmonic / 2,
                              .computed = share.middle() * harmonic / 2,
                              .tolerance = 0.01});
  return outcome;
}

/// Two cards that stand on an edge each and lean against each other with faces cut upright, seen along y.
struct Card {
  double lean = 30, reach = 0.5, thickness = 0.02;  ///< degrees from upright; m, foot to the other card; m

  /// Foot, outer foot, upper and lower end of the upright face.
  std::array<Eigen::Vector2d, 4> outline() const {
    const double s = std::sin(radians(lean)), c = std::cos(radians(lean));
    const Eigen::Vector2d along(s, c), across(-c, s);
    return {Eigen::Vector2d(0, 0), thickness * across, thickness * across + (reach + thickness * c) / s * along,
            reach / s * along};
  }
  Eigen::Vector2d centroid() const {
    const auto ring = outline();
    Eigen::Vector2d moment(0, 0);
    double area = 0;
    for (int k = 0; k < 4; ++k) {
      const auto &a = ring[k], &b = ring[(k + 1) % 4];
      const double cross = a.x() * b.y() - a.y() * b.x();
      area += cross / 2;
      moment += cross / 6 * (a + b);
    }
    return moment / area;
  }
  /// The cards push each other at the upper end as their feet go apart: H · height = W · arm, and H = μ W at the foot.
  /// For thin cards this is ½ tan(lean).
  double least_friction() const { return centroid().x() / outline()[2].y(); }
};

void add_card(CaseScene& scene, const std::string& name, const Card& card, bool mirrored) {
  const auto [foot, outer, upper, lower] = card.outline();
  // Mirrored, the foot comes first from the left; so the corners keep their sense.
  const std::array<Eigen::Vector2d, 4> section =
      mirrored ? std::array{foot, outer, lower, upper} : std::array{outer, foot, upper, lower};
  std::array<Vec3, 8> corners;  // bits: to the right, to the back, up
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector2d& point = section[(k & 1) + (k & 4 ? 2 : 0)];
    const double x = mirrored ? card.reach - point.x() : point.x() - card.reach;
    corners[k] = Vec3(x, k & 2 ? 0.25 : -0.25, point.y());
  }
  scene.add_block(name, hexahedron_mesh(corners, 1, 1, 4), BodyKind::tetrahedra);
}

CaseScene leaning_cards(const Card& card, double friction) {
  CaseScene scene = rock_scene(degrees(std::atan(friction)));
  scene.add_fixed_box("table", Vec3(-2, -1, -0.5), Vec3(2, 1, 0));
  add_card(scene, "left", card, false);
  add_card(scene, "right", card, true);
  scene.project.stages = {static_stage(0.01, 50), dynamic_stage(0.01, 3)};
  return scene;
}

CaseOutcome cards(const CaseOptions& options, Progress& progress) {
  const Card card;
  const double expected = card.least_friction();
  const Bracket friction = narrowed({0.97 * expected, 1.03 * expected}, options.thorough ? 7 : 4, [&](double trial) {
    return sets_off(leaning_cards(card, trial), lid_moved, options, progress);
  });
  CaseOutcome outcome;
  outcome.findings.push_back({.quantity = "least friction coefficient at the foot",
                              .unit = "",
                              .expected = expected,
                              .computed = friction.middle(),
                              .tolerance = 0.01});
  return outcome;
}

}  // namespace

std::vector<KnownCase> resting_cases() {
  return {{.name = "slope_32_blocks",
           .title = "32 blocks on a slope of 26.5°, φ = 30°: nothing moves",
           .source = "Coulomb: α < φ",
           .of_any_body = true,
           .run = slope},
          {.name = "overhanging_bricks",
           .title = "Bricks overhang a table",
           .source = "(L/2) Σ 1/i",
           .thinned = true,
           .of_any_body = true,
           .run = overhang},
          {.name = "leaning_cards",
           .title = "Two cards lean against each other",
           .source = "moments about the foot; ½ tan θ for thin cards",
           .thinned = true,
           .of_any_body = true,
           .run = cards}};
}

}  // namespace talus
