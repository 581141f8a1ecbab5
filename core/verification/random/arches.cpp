#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "mesh/structured_mesh.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/hard_cases/expectations.hpp"
#include "verification/known_answers/blocks/voussoirs.hpp"
#include "verification/random/families.hpp"
#include "verification/random/random_parts.hpp"

// Semicircular arches of voussoirs, beside what a thrust line asks of thickness and friction (limit analysis).
namespace talus {

namespace {

constexpr double arch_unrest = 1e-6, fallen_share = 0.05;  // of the mean radius
constexpr double falling_times = 6;                        // √(R/g)
constexpr double arch_gravity = 9.81;                      // m/s²

enum class ArchEnd { stands, too_thin, too_slippery };

/// An arch whose joints have that friction, and what it must come to: a tenth from the threshold at least.
struct RandomArch {
  Arch arch;
  double friction;  ///< degrees
  ArchEnd end;

  explicit RandomArch(SceneNumbers& numbers)
      : arch{numbers.whole(5, 15), 0}, friction(numbers.between(35, 60)), end(ArchEnd::stands) {
    const double least = least_thickness(arch.voussoirs, std::tan(radians(friction))).value();
    const double thicker = numbers.logarithmic(1.1, 3), thinner = numbers.between(0.5, 0.9);
    const double slippery = numbers.between(0.3, 0.9);
    if (numbers.chance(0.5)) {
      arch.thickness = thicker * least;
    } else if (numbers.chance(0.5)) {
      end = ArchEnd::too_thin;
      arch.thickness = thinner * least;
    } else {
      end = ArchEnd::too_slippery;
      arch.thickness = thicker * least;
      friction = degrees(std::atan(slippery * least_friction(arch).value()));
    }
  }
};

std::string end_words(ArchEnd end) {
  switch (end) {
    case ArchEnd::stands:
      return "stands";
    case ArchEnd::too_thin:
      return "is too thin";
    case ArchEnd::too_slippery:
      break;
  }
  return "is too slippery";
}

void add_voussoirs(CaseScene& scene, const Arch& arch, double radius, double depth, Draw& draw) {
  for (int i = 0; i < arch.voussoirs; ++i)
    scene.add_block("stone " + std::to_string(i + 1), hexahedron_mesh(voussoir(arch, i, radius, depth), 1, 1, 1),
                    draw.body());
}

/// One block at least comes down by so much [m].
HardCaseExpectation comes_down(double least) {
  return {"a stone comes down by " + significant(least) + " m at least", [=](const Trajectory& trajectory) {
            double most = 0;
            for (const BlockMotion& stone : trajectory.last().blocks) most = std::max(most, -stone.displacement.z());
            return most >= least ? std::string() : "none comes down by more than " + significant(most) + " m";
          }};
}

}  // namespace

HardCase random_arch(Draw& draw) {
  SceneNumbers& numbers = draw.numbers;
  const RandomArch drawn_arch(numbers);
  const Arch& arch = drawn_arch.arch;
  const double radius = numbers.logarithmic(0.5, 20), depth = radius * numbers.between(0.1, 0.5);
  CaseScene scene = random_rock_scene(numbers, drawn_arch.friction);
  scene.project.solver.sleep_tolerance = 0;
  scene.project.materials[0].young = std::max(scene.project.materials[0].young, 1e10);
  scene.add_fixed_box("floor", {-3 * radius, -radius, -radius}, {3 * radius, radius, 0});
  add_voussoirs(scene, arch, radius, depth, draw);
  const double second = std::sqrt(radius / arch_gravity), step = second * numbers.logarithmic(5e-3, 2e-2);
  const bool stays = drawn_arch.end == ArchEnd::stands;
  if (stays)
    scene.project.stages = {settling_stage(0.01), dynamic_stage(step, 100 * step)};
  else
    scene.project.stages = {dynamic_stage(step, falling_times * second)};
  const Site site(numbers);
  place_scene(scene, site.turn(), site.shift);
  HardCase drawn;
  drawn.title = "arch of " + std::to_string(arch.voussoirs) + " stones, " + draw.bodies_word() + ", radius " +
                significant(radius) + " m, thickness " + significant(arch.thickness) + " of it, friction " +
                significant(drawn_arch.friction) + "°, " + end_words(drawn_arch.end) + ", " + site.words() +
                ", steps of " + significant(step) + " s";
  drawn.expected = {stays ? all_rest(0, arch_unrest * radius) : comes_down(fallen_share * radius),
                    stays_before(site.shift, Vec3::UnitZ())};
  drawn.has_blows = !stays;
  drawn.build = [scene] { return scene; };
  return drawn;
}

}  // namespace talus
