#include "verification/known_answers/blocks/block_cases.hpp"

#include <cmath>

#include "base/units.hpp"
#include "model/number_text.hpp"
#include "model/stages.hpp"
#include "verification/known_answers/blocks/voussoirs.hpp"
#include "verification/known_answers/support/bracket.hpp"
#include "verification/known_answers/support/recorded_run.hpp"

namespace talus {

namespace {

constexpr double radius = 10, depth = 2;  // m
constexpr int voussoirs = 27;
/// An arch whose farthest voussoir has gone this share of the radius within the run is falling.
constexpr double arch_moved = 2e-3;

CaseScene arch_scene(const Arch& arch, double friction) {
  CaseScene scene = rock_scene(degrees(std::atan(friction)));
  for (const double side : {-1.0, 1.0})
    scene.add_fixed_box(side < 0 ? "left springing" : "right springing", Vec3(side * radius - 4, -depth, -2),
                        Vec3(side * radius + 4, depth, 0));
  for (int i = 0; i < arch.voussoirs; ++i)
    scene.add_block("voussoir " + std::to_string(i + 1), hexahedron_mesh(voussoir(arch, i, radius, depth), 1, 1, 1),
                    BodyKind::tetrahedra);
  scene.project.stages = {static_stage(0.02, 100), dynamic_stage(0.02, 5)};
  return scene;
}

CaseOutcome thickness(const CaseOptions& options, Progress& progress) {
  const auto arch_falls = [&](double thick, double friction) {
    return sets_off(arch_scene({voussoirs, thick}, friction), arch_moved * radius, options, progress);
  };
  CaseOutcome outcome;
  CaseTable brackets{"Thickness over mean radius", {"μ", "least by limit analysis", "falls at", "stands at"}, {}};
  for (const double friction : {0.5, 0.35, 0.32}) {
    const double expected = *least_thickness(voussoirs, friction);
    const Bracket bracket = narrowed({0.97 * expected, 1.03 * expected}, options.thorough ? 6 : 3,
                                     [&](double thick) { return arch_falls(thick, friction); });
    brackets.rows.push_back(
        {decimals(friction, 2), decimals(expected, 5), decimals(bracket.falls, 5), decimals(bracket.stands, 5)});
    outcome.findings.push_back({.quantity = "least thickness/radius, μ " + decimals(friction, 2),
                                .unit = "",
                                .expected = expected,
                                .computed = bracket.middle(),
                                .tolerance = 0.01});
  }
  outcome.tables.push_back(brackets);
  const double slippery = 0.30;
  outcome.findings.push_back(
      {.quantity = "thickness 0.3 of the radius stands (1) or falls (0), μ " + decimals(slippery, 2),
       .unit = "",
       .expected = stands({voussoirs, 0.3}, slippery) ? 1.0 : 0.0,
       .computed = arch_falls(0.3, slippery) ? 0.0 : 1.0,
       .tolerance = 0,
       .absolute = true});
  return outcome;
}

}  // namespace

std::vector<KnownCase> arch_cases() {
  return {{.name = "arch",
           .title = "Semicircular arch of 27 voussoirs under its own weight",
           .source = "thrust line within the joints; Milankovitch 1907",
           .thinned = true,
           .of_any_body = true,
           .run = thickness}};
}

}  // namespace talus
