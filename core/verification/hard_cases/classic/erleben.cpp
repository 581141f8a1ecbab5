#include "model/stages.hpp"
#include "verification/hard_cases/classic/classic_scenes.hpp"

/// Ten degenerate contacts of spikes, wedges and boxes (Erleben 2018, Methodology for assessing mesh-based contact
/// point methods), as the soft bodies with a friction coefficient of 1 that Li et al. 2020 (Incremental potential
/// contact) made of them.
namespace talus {

namespace {

constexpr const char* source = "Erleben 2018; Li et al. 2020 (IPC)";
constexpr double height = 3;                       // m, of spikes and wedges; bases 1 × 1 and 1 × 2
constexpr double time_step = 5e-3, duration = 10;  // s

TetMesh pointed(bool is_wedge) { return is_wedge ? wedge(1, 2, height) : spike(1, height); }

CaseScene soft_scene() {
  CaseScene scene =
      scene_of({.name = "soft", .density = 1000, .young = 1e5, .poisson = 0.4, .law = MaterialLaw::neo_hookean}, 1);
  scene.project.solver.penetration_tolerance = 5e-4;  // published bodies keep apart; these may by half the limit
  scene.project.stages = {dynamic_stage(time_step, duration)};
  return scene;
}

CaseScene contact(const TetMesh& base, const TetMesh& body) {
  CaseScene scene = soft_scene();
  scene.add_block("base", base, BodyKind::fixed);
  scene.add_block("body", body, BodyKind::tetrahedra);
  return scene;
}

/// Tip on tip, the lower one held. Tips of one tetrahedron give by up to a metre: W/(E·A/L) at half height.
HardCase on_top(const std::string& name, const std::string& title, bool wedge_above, bool wedge_below) {
  return {.name = "erleben_" + name,
          .group = classic_group,
          .title = title,
          .source = source,
          .expected = {stays_before({0, 0, -height}, Vec3::UnitZ()), comes_down_aside("body", Vec3::UnitZ(), 1.5)},
          .build = [=] {
            CaseScene scene = contact(placed(pointed(wedge_below), {0, 0, -height}),
                                      placed(pointed(wedge_above), upside_down(), {0, 0, height}));
            scene.add_fixed_box("floor", {-40, -40, -height - 1}, {40, 40, -height});
            return scene;
          }};
}

/// Point down in an opening 0.5 m wide, which it fills at half its height. The base, twice as wide, goes in only if
/// squeezed to half: by E/2 on about 1 m² a side, whose friction alone bears ten times the weight.
HardCase in_opening(const std::string& name, const std::string& title, bool is_wedge, const TetMesh& base) {
  return {.name = "erleben_" + name,
          .group = classic_group,
          .title = title,
          .source = source,
          .expected = {stays_before({0, 0, -height / 4}, Vec3::UnitZ())},
          .build = [=] {
            return contact(base, placed(pointed(is_wedge), upside_down(), {0, 0, height / 2}));
          }};
}

/// Slides 100 m at 10 m/s, touching 7 m of inner edges and then an outer one, and nothing presses it on: nothing holds
/// it.
HardCase slider(const std::string& name, const std::string& title, bool is_wedge) {
  return {.name = "erleben_" + name,
          .group = classic_group,
          .title = title,
          .source = source,
          .expected = {travels("body", Vec3::UnitX(), 10 * duration, 1e-6)},
          .build = [=] {
            // The wedge's edge lies across the direction of sliding.
            CaseScene scene = contact(box_mesh({-4, -4, -1}, {4, 4, 0}, 16, 16, 2),
                                      placed(pointed(is_wedge), upside_down(), {-3, 0, height}));
            scene.project.gravity.setZero();
            scene.project.velocities = {{.block = "body", .linear = {10, 0, 0}}};
            return scene;
          }};
}

/// A cube of 1 m sags by ρgh²/3E = 3 cm, twice that at once, and goes nowhere. Diagonals that all run one way turn a
/// part of such a strain, a tenth at the base, into shear: it may lean by half of that, 3°.
HardCase standing(const std::string& name, const std::string& title, const TetMesh& base) {
  return {.name = "erleben_" + name,
          .group = classic_group,
          .title = title,
          .source = source,
          .expected = {rests("body", -1, 0.15, 3)},
          .build = [=] {
            return contact(base, box_mesh({-0.5, -0.5, 0}, {0.5, 0.5, 1}, 2, 2, 2));
          }};
}

}  // namespace

std::vector<HardCase> erleben_scenes() {
  const TetMesh crack = slotted_box(0.5, height, 2, 2, 0.5);
  return {on_top("spike_on_spike", "Soft spike on the tip of a spike", false, false),
          on_top("spike_on_wedge", "Soft spike on the ridge of a wedge", false, true),
          on_top("wedge_on_wedge", "Soft wedge on the ridge of a wedge", true, true),
          in_opening("spike_in_crack", "Soft spike in a crack", false, crack),
          in_opening("wedge_in_crack", "Soft wedge in a crack", true, crack),
          in_opening("spike_in_hole", "Soft spike in a square hole", false, holed_box(0.5, height, 2, 0.5)),
          slider("sliding_spike", "Spike at 10 m/s over a meshed face, without gravity", false),
          slider("sliding_wedge", "Wedge at 10 m/s over a meshed face, without gravity", true),
          standing("cliff_edges", "Soft cube on a box with the same outline",
                   box_mesh({-0.5, -0.5, -1}, {0.5, 0.5, 0}, 2, 2, 2)),
          standing("internal_edges", "Soft cube across the inner edges of a face",
                   box_mesh({-2.13, -2.07, -1}, {1.87, 1.93, 0}, 8, 8, 2, true))};
}

}  // namespace talus
