// How far answers move when a tolerance is doubled or halved, on a sample of the hard cases.
//   OPENBLAS_NUM_THREADS=1 build/release/tests/bench/bench_tolerances [NAME…]
// Prints a row for each tolerance, all of them unless names are given; tools/measure_tolerances.py makes
// docs/tolerances.md of them.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "base/progress.hpp"
#include "mesh/mesh_size.hpp"
#include "verification/hard_cases/scenes/all_hard_cases.hpp"
#include "verification/hard_cases/trial.hpp"

namespace talus {
namespace {

/// Some of every group, together about four seconds.
const std::vector<std::string> sample = {"vertex_on_vertex_pushed",
                                         "spike_on_spike_dropped",
                                         "edge_across_edge_pushed",
                                         "faces_shifted_dropped",
                                         "erleben_wedge_in_crack",
                                         "chain_5_swings",
                                         "turntable_1",
                                         "friction_89_thrown",
                                         "slivers_dropped",
                                         "needles_fall_3",
                                         "plate_at_100_free",
                                         "poured_8",
                                         "interlocked_4",
                                         "arch_25",
                                         "friction_drops",
                                         "load_reversed_slides",
                                         "column_1_degree_topples",
                                         "domino_row_5"};

struct Entry {
  std::string name;
  std::function<void(Tolerances&, double factor)> scale;
};

void scale(double& value, double factor) { value *= factor; }
/// Counts stay counts: half of three is two.
void scale(int& value, double factor) { value = std::max(1, static_cast<int>(std::lround(value * factor))); }

template <class Group>
struct Member {
  const char* name;
  std::variant<double Group::*, int Group::*> value;
};

template <class Group>
void add(std::vector<Entry>& entries, const std::string& prefix, Group& (*group)(Tolerances&),
         const std::vector<Member<Group>>& members) {
  for (const Member<Group>& member : members)
    entries.push_back({prefix + member.name, [group, member](Tolerances& all, double factor) {
                         std::visit([&](auto value) { scale(group(all).*value, factor); }, member.value);
                       }});
}

/// All tolerances but FirstGuessTolerances::better, which is a fraction next to 1.
std::vector<Entry> entries() {
  std::vector<Entry> all;
  {
    using G = ContactTolerances;
    add<G>(all, "contact.", [](Tolerances& t) -> G& { return t.contact; },
           {{"face_face_angle", &G::face_face_angle},
            {"largest_depth", &G::largest_depth},
            {"depth_per_penetration", &G::depth_per_penetration},
            {"flush_angle", &G::flush_angle},
            {"outside_facet", &G::outside_facet},
            {"past_edge_end", &G::past_edge_end},
            {"convex_edge_angle", &G::convex_edge_angle},
            {"parallel_edges", &G::parallel_edges},
            {"least_edge_tolerance", &G::least_edge_tolerance},
            {"most_edge_tolerance", &G::most_edge_tolerance},
            {"edge_tolerance_per_penetration", &G::edge_tolerance_per_penetration},
            {"clearly_shallower", &G::clearly_shallower},
            {"same_place", &G::same_place},
            {"beside_edge_at_node", &G::beside_edge_at_node},
            {"opposite_edges", &G::opposite_edges},
            {"least_overlap_area", &G::least_overlap_area},
            {"at_vertex", &G::at_vertex},
            {"noticeable_tilt", &G::noticeable_tilt},
            {"noticeable_spread", &G::noticeable_spread},
            {"least_facet_area", &G::least_facet_area},
            {"same_corner", &G::same_corner},
            {"least_sector", &G::least_sector},
            {"least_stencil_weight", &G::least_stencil_weight},
            {"deepest_core", &G::deepest_core},
            {"least_core_distance", &G::least_core_distance},
            {"core_regularization", &G::core_regularization},
            {"noticeable_motion", &G::noticeable_motion},
            {"sharp_edge_faces", &G::sharp_edge_faces},
            {"transfer_along_features", &G::transfer_along_features},
            {"transfer_across_features", &G::transfer_across_features},
            {"transfer_agreement", &G::transfer_agreement},
            {"least_turned_shear", &G::least_turned_shear},
            {"same_compression", &G::same_compression},
            {"bonded_gap", &G::bonded_gap},
            {"foreseen_slide", &G::foreseen_slide},
            {"noticeable_slide", &G::noticeable_slide},
            {"noticeable_deepening", &G::noticeable_deepening},
            {"inward_normal", &G::inward_normal},
            {"least_direction", &G::least_direction},
            {"on_common_plane", &G::on_common_plane}});
  }
  {
    using G = StepTolerances;
    add<G>(all, "solver.step.", [](Tolerances& t) -> G& { return t.solver.step; },
           {{"cut_factor", &G::cut_factor},
            {"shortest_step", &G::shortest_step},
            {"shortest_way", &G::shortest_way},
            {"reach_factor", &G::reach_factor},
            {"least_reach", &G::least_reach},
            {"correction_limit", &G::correction_limit},
            {"corrected_residual", &G::corrected_residual},
            {"penetration", &G::penetration},
            {"shortest_recheck", &G::shortest_recheck},
            {"fewest_static_steps", &G::fewest_static_steps},
            {"time_rounding", &G::time_rounding}});
  }
  {
    using G = ConvergenceTolerances;
    add<G>(all, "solver.convergence.", [](Tolerances& t) -> G& { return t.solver.convergence; },
           {{"dynamic_residual", &G::dynamic_residual},
            {"static_residual", &G::static_residual},
            {"rounding_residual", &G::rounding_residual},
            {"stalled_fraction", &G::stalled_fraction},
            {"stalled_iterations", &G::stalled_iterations},
            {"rounding_factor", &G::rounding_factor},
            {"elastic_force_weight", &G::elastic_force_weight},
            {"momentum_force_weight", &G::momentum_force_weight},
            {"negligible_system", &G::negligible_system},
            {"work_of_residual", &G::work_of_residual},
            {"first_closing", &G::first_closing},
            {"friction_settled", &G::friction_settled},
            {"hard_step", &G::hard_step},
            {"newton_iterations", &G::newton_iterations},
            {"closing_iterations", &G::closing_iterations},
            {"interior_point_unknowns", &G::interior_point_unknowns},
            {"interior_point_limit", &G::interior_point_limit},
            {"interior_point_residual", &G::interior_point_residual},
            {"hopeless_residual", &G::hopeless_residual},
            {"reduced", &G::reduced},
            {"slope_turned", &G::slope_turned},
            {"negligible_part", &G::negligible_part},
            {"well_reduced", &G::well_reduced},
            {"frozen_reduction", &G::frozen_reduction},
            {"line_search_limit", &G::line_search_limit},
            {"overshot", &G::overshot},
            {"flat_slope", &G::flat_slope},
            {"gmres", &G::gmres},
            {"gmres_limit", &G::gmres_limit},
            {"incomplete_limit", &G::incomplete_limit}});
  }
  {
    using G = FirstGuessTolerances;
    add<G>(all, "solver.first_guess.", [](Tolerances& t) -> G& { return t.solver.first_guess; },
           {{"creeping", &G::creeping}, {"clearly_better", &G::clearly_better}});
  }
  {
    using G = InteriorPointTolerances;
    add<G>(all, "solver.interior_point.", [](Tolerances& t) -> G& { return t.solver.interior_point; },
           {{"smallest_target", &G::smallest_target},
            {"short_fraction", &G::short_fraction},
            {"short_iterations", &G::short_iterations},
            {"to_boundary", &G::to_boundary},
            {"least_displacement", &G::least_displacement},
            {"most_slip", &G::most_slip},
            {"flight_gap", &G::flight_gap},
            {"least_gap", &G::least_gap}});
  }
  {
    using G = EliminationTolerances;
    add<G>(all, "solver.elimination.", [](Tolerances& t) -> G& { return t.solver.elimination; },
           {{"unbalanced", &G::unbalanced},
            {"most_bodies", &G::most_bodies},
            {"few_bodies", &G::few_bodies},
            {"iterations", &G::iterations},
            {"iterations_on_way", &G::iterations_on_way}});
  }
  {
    using G = ContactOutcomeTolerances;
    add<G>(all, "solver.contact_outcome.", [](Tolerances& t) -> G& { return t.solver.contact_outcome; },
           {{"bond_opening", &G::bond_opening}});
  }
  {
    using G = PenaltyScalingTolerances;
    add<G>(all, "solver.penalty_scaling.", [](Tolerances& t) -> G& { return t.solver.penalty_scaling; },
           {{"factor", &G::factor},
            {"repeated_factor", &G::repeated_factor},
            {"least_compression", &G::least_compression},
            {"faces_in_all", &G::faces_in_all},
            {"largest", &G::largest}});
  }
  {
    using G = AccelerationResetTolerances;
    add<G>(all, "solver.acceleration_reset.", [](Tolerances& t) -> G& { return t.solver.acceleration_reset; },
           {{"sudden_change", &G::sudden_change}, {"swing", &G::swing}, {"visible_swing", &G::visible_swing}});
  }
  {
    using G = ImpactTolerances;
    add<G>(all, "solver.impact.", [](Tolerances& t) -> G& { return t.solver.impact; },
           {{"steps_to_part", &G::steps_to_part},
            {"landing_gap", &G::landing_gap},
            {"followed_oscillation", &G::followed_oscillation},
            {"negligible_speed", &G::negligible_speed},
            {"negligible_energy", &G::negligible_energy},
            {"impulse_accuracy", &G::impulse_accuracy},
            {"sweep_limit", &G::sweep_limit}});
  }
  {
    using G = FollowedSpringTolerances;
    add<G>(all, "solver.followed_spring.", [](Tolerances& t) -> G& { return t.solver.followed_spring; },
           {{"oscillation", &G::oscillation},
            {"relaxed_compression", &G::relaxed_compression},
            {"worthwhile_softening", &G::worthwhile_softening},
            {"relaxed_interference", &G::relaxed_interference}});
  }
  {
    using G = PseudoTransientTolerances;
    add<G>(all, "solver.pseudo_transient.", [](Tolerances& t) -> G& { return t.solver.pseudo_transient; },
           {{"power", &G::power},
            {"steady_residual", &G::steady_residual},
            {"growth", &G::growth},
            {"largest_displacement", &G::largest_displacement},
            {"least_inertia", &G::least_inertia},
            {"at_rest", &G::at_rest}});
  }
  {
    using G = StepControlTolerances;
    add<G>(all, "solver.step_control.", [](Tolerances& t) -> G& { return t.solver.step_control; },
           {{"target", &G::target},
            {"growth", &G::growth},
            {"shrinkage", &G::shrinkage},
            {"refused_above", &G::refused_above},
            {"after_many_iterations", &G::after_many_iterations},
            {"after_refusal", &G::after_refusal}});
  }
  {
    using G = SleepTolerances;
    add<G>(all, "solver.sleep.", [](Tolerances& t) -> G& { return t.solver.sleep; },
           {{"slow_steps", &G::slow_steps}, {"speed", &G::speed}, {"load_change", &G::load_change}});
  }
  {
    using G = EffectTolerances;
    add<G>(all, "solver.effects.", [](Tolerances& t) -> G& { return t.solver.effects; },
           {{"search_gap", &G::search_gap},
            {"constraint_stiffness", &G::constraint_stiffness},
            {"point_outside_block", &G::point_outside_block},
            {"negligible_turn", &G::negligible_turn},
            {"stiffness_kept", &G::stiffness_kept},
            {"kept_volume", &G::kept_volume},
            {"slides_on", &G::slides_on},
            {"least_excess", &G::least_excess},
            {"slip_roundings", &G::slip_roundings}});
  }
  return all;
}

/// The sample once, with these tolerances.
std::vector<Trial> run_sample(const std::vector<HardCase>& scenes, const Tolerances& tolerances) {
  std::vector<Trial> trials;
  for (const HardCase& scene : scenes) {
    NoProgress silent;
    trials.push_back(run_trial(scene, {.threads = 1, .tolerances = tolerances}, silent));
  }
  return trials;
}

/// What becomes of the sample with other tolerances.
struct Change {
  double displacement = 0;  ///< largest difference of where a block ends, over its mesh size
  std::string of;           ///< the scene in which that is
  double iterations = 0;    ///< of all scenes, over those of before, less 1
  std::string failing;      ///< scenes that do not hold what they must
};

Change compare(const std::vector<Trial>& before, const std::vector<Trial>& after,
               const std::vector<std::vector<double>>& sizes) {
  Change change;
  long iterations_before = 0, iterations_after = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    iterations_before += before[i].iterations;
    iterations_after += after[i].iterations;
    if (!after[i].passed()) change.failing += (change.failing.empty() ? "" : ", ") + after[i].name;
    const std::size_t blocks = std::min(before[i].displacements.size(), after[i].displacements.size());
    for (std::size_t b = 0; b < blocks; ++b) {
      const double moved = (before[i].displacements[b] - after[i].displacements[b]).norm() / sizes[i][b];
      if (moved <= change.displacement) continue;
      change.displacement = moved;
      change.of = after[i].name;
    }
  }
  change.iterations = static_cast<double>(iterations_after) / static_cast<double>(iterations_before) - 1;
  return change;
}

std::string text_of(const Change& change) {
  char numbers[80];
  std::snprintf(numbers, sizeof numbers, "%.1e", change.displacement);
  std::string text = change.displacement == 0 ? "0" : std::string(numbers) + " (" + change.of + ")";
  std::snprintf(numbers, sizeof numbers, "%+.1f %%", 100 * change.iterations);
  return text + " | " + numbers + " | " + (change.failing.empty() ? "–" : change.failing);
}

std::vector<HardCase> sampled_scenes() {
  std::vector<HardCase> scenes;
  for (HardCase& scene : hard_cases())
    if (std::ranges::find(sample, scene.name) != sample.end()) scenes.push_back(std::move(scene));
  return scenes;
}

std::vector<std::vector<double>> mesh_sizes(const std::vector<HardCase>& scenes) {
  std::vector<std::vector<double>> sizes;
  for (const HardCase& scene : scenes) {
    sizes.emplace_back();
    for (const Block& block : scene.build().system.blocks)
      sizes.back().push_back(mesh_size(block.mesh.nodes, block.surface));
  }
  return sizes;
}

void measure(const std::vector<std::string>& wanted) {
  const std::vector<HardCase> scenes = sampled_scenes();
  const auto sizes = mesh_sizes(scenes);
  const std::vector<Trial> before = run_sample(scenes, {});
  for (const Entry& entry : entries()) {
    if (!wanted.empty() && std::ranges::find(wanted, entry.name) == wanted.end()) continue;
    std::printf("| %s", entry.name.c_str());
    for (const double factor : {2.0, 0.5}) {
      Tolerances other;
      entry.scale(other, factor);
      std::printf(" | %s", text_of(compare(before, run_sample(scenes, other), sizes)).c_str());
    }
    std::printf(" |\n");
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace talus

int main(int count, char** words) {
  const std::vector<std::string> wanted(words + 1, words + count);
  if (wanted == std::vector<std::string>{"--list"})
    for (const talus::Entry& entry : talus::entries()) std::printf("%s\n", entry.name.c_str());
  else
    talus::measure(wanted);
}
