#include "model/number_text.hpp"
#include "model/solver_tolerances.hpp"
#include "model/stage_length.hpp"
#include "model/tolerance_text.hpp"
#include "report/sections.hpp"
#include "report/words.hpp"

namespace talus::report {

namespace {

/// What a stage changes beside its kind and length.
std::string changes_text(const Stage& stage) {
  std::string text;
  const auto add = [&](const std::string& what) { text += (text.empty() ? "" : "; ") + what; };
  if (stage.until_equilibrium)
    add("ends in equilibrium, at " + given(stage.equilibrium_tolerance) + " of the largest force");
  if (stage.damping) add("damping " + given(*stage.damping) + " 1/s");
  for (const JointChange& joint : stage.joints) {
    std::string words = "joint " + joint.name + ":";
    if (joint.friction_angle) words += " φ " + given(*joint.friction_angle) + "°";
    if (joint.residual_friction_angle) words += " residual φ " + given(*joint.residual_friction_angle) + "°";
    if (joint.cohesion) words += " c " + quantity(*joint.cohesion, "Pa");
    if (joint.tensile_strength) words += " tensile strength " + quantity(*joint.tensile_strength, "Pa");
    add(words);
  }
  if (stage.loads)
    add(counted_text(static_cast<long>(stage.loads->size()), "load", "loads") + " in place of those before");
  if (stage.constraints)
    add(counted_text(static_cast<long>(stage.constraints->size()), "constraint", "constraints") +
        " in place of those before");
  for (const BlockChange& block : stage.blocks)
    add("block " + block.name + (block.body == BodyKind::fixed ? " held" : " let go"));
  return text.empty() ? "–" : text;
}

Table stages(const Project& project) {
  Table table{"Stages", {"Stage", "Type", "Time step (s)", "Length (s)", "Changes"}, "llrrl", {}};
  for (const Stage& stage : project.stages)
    table.rows.push_back({stage.name, std::string(to_string(stage.kind)), given(stage.time_step),
                          (stage.until_equilibrium ? "≤ " : "") + given(length_of(stage)), changes_text(stage)});
  return table;
}

std::string integrator_text(const SolverSettings& solver) {
  switch (solver.integrator) {
    case Integrator::newmark:
      return "Newmark, γ = 1, β = 9/16";
    case Integrator::constant_acceleration:
      return "Newmark, γ = 1, β = 1/2 (constant acceleration)";
    case Integrator::generalized_alpha:
      break;
  }
  return "generalised α, spectral radius " + given(solver.spectral_radius);
}

std::string penetration_text(const SolverSettings& solver) {
  if (solver.penetration_tolerance) return given(*solver.penetration_tolerance) + " of the mesh size";
  const SolverTolerances tolerances = SolverTolerances{}.at(solver.tolerance);
  const double by_spring = tolerances.step.penetration, in_all = tolerances.penalty_scaling.faces_in_all * by_spring;
  return "automatic: springs give by " + given(by_spring) + " of the mesh size, faces of rigid and affine blocks lie " +
         given(in_all) + " deep in all";
}

std::string step_control_text(const SolverSettings& solver) {
  if (solver.time_step_control == TimeStepControl::fixed) return "fixed; a step that does not converge is cut";
  const AdaptiveSteps& limits = solver.adaptive;
  return "adaptive: a step moves no node by more than " + percent(limits.displacement_limit) +
         " of half the model’s height, errs by no more than " + percent(limits.error_limit) +
         " of the smallest mesh size, and takes about " + std::to_string(limits.iterations) + " iterations";
}

/// What the project switches on or off by hand; empty where all is as the scene calls for.
std::string switches_text(const SolverSettings& solver) {
  std::string text;
  for_each_switch(solver.effects, [&](const char* name, Switch choice) {
    if (choice != Switch::called_for)
      text += (text.empty() ? "" : ", ") + std::string(name) + " " + std::string(to_string(choice));
  });
  return text;
}

Facts scheme(const SolverSettings& solver) {
  Facts facts;
  facts.rows = {
      {"Tolerance", tolerance_text(solver.tolerance) + ": a step has converged when what is out of balance is below " +
                        given(solver.tolerance) + " of the largest force"},
      {"Preset", solver.preset == Preset::talus ? "Talus’s own scheme" : "the paper’s scheme"},
      {"Strain", std::string(to_string(solver.strain))},
      {"Time integration", integrator_text(solver)},
      {"Contact model",
       std::string(solver.contact == ContactModel::area ? "by the area over which facets face each other"
                                                        : "by facets, as in the paper") +
           ", normal penalty " + given(solver.contact_stiffness) + " E*/h"},
      {"Penetration allowed", penetration_text(solver)},
      {"Open–close iteration",
       std::string(solver.open_close == OpenCloseMethod::newton ? "Newton’s method on the law of contacts"
                                                                : "states are held for a round, as in the paper") +
           ", at most " + std::to_string(solver.open_close_limit) + " iterations a step"},
      {"Time steps", step_control_text(solver)}};
  if (const std::string switches = switches_text(solver); !switches.empty())
    facts.rows.push_back({"Switched by hand", switches});
  return facts;
}

/// What acts beside gravity; empty where nothing does.
std::string actions_text(const Project& project) {
  std::string text;
  const auto add = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0) text += (text.empty() ? "" : ", ") + counted_text(static_cast<long>(count), one, many);
  };
  add(project.loads.size(), "point load", "point loads");
  add(project.constraints.size(), "constraint", "constraints");
  add(project.velocities.size(), "initial velocity", "initial velocities");
  add(project.in_situ.size(), "stress in situ", "stresses in situ");
  return text;
}

}  // namespace

Section settings(const RunRecord& run) {
  if (!run.project) return {"How it was solved", {}};
  Section section{"How it was solved", {stages(*run.project)}};
  if (const std::string actions = actions_text(*run.project); !actions.empty())
    section.parts.emplace_back(Paragraph{"Beside gravity acts: " + actions + "."});
  section.parts.emplace_back(scheme(run.project->solver));
  return section;
}

}  // namespace talus::report
