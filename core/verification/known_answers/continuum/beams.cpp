#include <cmath>

#include "model/stages.hpp"
#include "verification/known_answers/continuum/continuum_cases.hpp"
#include "verification/known_answers/support/convergence.hpp"
#include "verification/known_answers/support/scene.hpp"
#include "verification/known_answers/support/surface_loads.hpp"

namespace talus {

namespace {

// A square beam of Poisson's ratio 0: at the clamped end nothing wants to widen, so that beam theory holds up to there.
constexpr double beam_length = 5, beam_height = 1, young = 10e9;
/// Deflection of 1e-4 of the length: what is not linear in it stays below 1e-8.
constexpr double force = 1e4;

/// Timoshenko's beam: PL³/3EI + PL/κGA with κ = 5/6 and G = E/2.
double beam_theory() {
  constexpr double area = beam_height * beam_height,
                   inertia = beam_height * beam_height * beam_height * beam_height / 12;
  return force * beam_length * beam_length * beam_length / (3 * young * inertia) +
         force * beam_length / (5.0 / 6 * young / 2 * area);
}

CaseScene cantilever(int cells) {
  CaseScene scene;
  scene.project.gravity.setZero();
  scene.add_material({.name = "rock", .density = 2600, .young = young, .poisson = 0});
  scene.add_block("beam", box_mesh({0, 0, 0}, {beam_length, beam_height, beam_height}, 5 * cells, cells, cells),
                  BodyKind::tetrahedra);
  const Block& block = scene.system.blocks.front();
  for (const Vec3& node : block.mesh.nodes)
    if (node.x() == 0)
      scene.project.constraints.push_back({.block = "beam", .at = node, .displacement = {0, 0, 0}, .table = {}});
  scene.project.loads = surface_loads(block, [](const Vec3&, const Vec3& normal) {
    return Vec3(0, 0, normal.x() > 0.5 ? -force / (beam_height * beam_height) : 0);
  });
  for (const PointLoad& load : scene.project.loads) scene.add_monitor("tip", "beam", load.at);
  scene.project.stages.push_back(static_stage(10, 3));
  return scene;
}

/// Deflection of the tip, weighted as the load is spread: the work of the load over the load [m], at full scale.
double tip_deflection(const CaseScene& scene, const CaseOptions& options, Progress& progress) {
  double deflection = 0;
  run_scene(as_asked(scene, options), progress, [&](const Simulation& simulation, const StepReport&) {
    const HistoryRow row = simulation.history();
    deflection = 0;
    for (std::size_t i = 0; i < row.monitors.size(); ++i)
      deflection += row.monitors[i].displacement.z() * scene.project.loads[i].force.z() / force / options.scale;
    return true;
  });
  return deflection;
}

CaseOutcome bend(const CaseOptions& options, Progress& progress) {
  const double expected = beam_theory();
  std::vector<Refinement> series;
  for (int cells = 2; cells <= (options.thorough ? 16 : 8); cells *= 2) {
    const double tip = tip_deflection(cantilever(cells), options, progress);
    series.push_back({std::to_string(cells), tip, std::abs(tip / expected - 1)});
  }
  const Refinement &coarse = series[series.size() - 2], &fine = series.back();
  CaseOutcome outcome;
  outcome.findings.push_back({.quantity = "tip deflection, Richardson's limit with order 2",
                              .unit = "m",
                              .expected = expected,
                              .computed = richardson_limit(coarse.value, fine.value, 2),
                              .tolerance = 0.02});
  outcome.findings.push_back({.quantity = "order of convergence",
                              .unit = "",
                              .expected = 2,
                              .computed = observed_order(coarse.error, fine.error),
                              .tolerance = 0.15});
  outcome.findings.push_back({.quantity = "tip deflection, finest mesh",
                              .unit = "m",
                              .expected = expected,
                              .computed = fine.value,
                              .tolerance = 0.01,
                              .reported = true});
  outcome.tables.push_back(convergence_table("Cantilever", "cells in the height", "tip deflection [m]", series));
  outcome.remarks.push_back(
      "Four-node tetrahedra are too stiff in bending: with two cells in the height the beam sinks "
      "by " +
      short_number(100 * series.front().value / expected) + " % of what it should.");
  return outcome;
}

}  // namespace

std::vector<KnownCase> beam_cases() {
  return {{.name = "cantilever",
           .title = "Tip deflection of a cantilever: order of convergence",
           .source = "Timoshenko: PL³/3EI + PL/(κ GA), κ = 5/6; linear elements converge with order 2",
           .thinned = true,
           .run = bend}};
}

}  // namespace talus
