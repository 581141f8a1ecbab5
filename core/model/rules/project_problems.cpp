#include "model/rules/project_problems.hpp"

#include <algorithm>
#include <set>

#include "model/number_text.hpp"
#include "model/require.hpp"
#include "model/rules/switched_effects.hpp"
#include "model/rules/validate.hpp"

namespace talus {

namespace {

using Kind = ProjectProblem::Kind;

void add_broken_rules(const Project& project, std::vector<ProjectProblem>& problems) {
  BrokenRules broken;
  try {
    validate(project);
  } catch (const InputError& error) {
    broken.add(error);
  }
  for (const InputError& error : broken.all())
    problems.push_back({Kind::error, error.place(), error.problem(), error.remedy()});
}

void add(std::vector<ProjectProblem>& problems, Kind kind, const Place& place, const std::string& problem,
         const std::string& remedy) {
  problems.push_back({kind, place.text(), problem, remedy});
}

void look_for_unused(const Project& project, std::vector<ProjectProblem>& problems) {
  std::set<std::string> materials, joints{project.default_joint};
  for (const Solid& solid : project.solids) materials.insert(solid.material);
  for (const BlockOverride& block : project.blocks) materials.insert(block.material.value_or(""));
  for (const Cut& cut : project.cuts) joints.insert(cut.joint);
  for (const Interface& interface : project.interfaces) joints.insert(interface.joint);
  for (const Material& material : project.materials)
    if (!materials.contains(material.name))
      add(problems, Kind::hint, Place() / "materials" / material.name, "no solid or block is made of it",
          "give it to a solid, or remove it");
  for (const Joint& joint : project.joints)
    if (!joints.contains(joint.name))
      add(problems, Kind::hint, Place() / "joints" / joint.name, "no cut, pair of blocks or default uses it",
          "let a cut use it, or remove it");
}

/// Orders of magnitude of rock: who types MPa where Pa are kept is told.
void look_at_materials(const Project& project, std::vector<ProjectProblem>& problems) {
  constexpr double light = 500, heavy = 8000;  // kg/m³: pumice, ores
  constexpr double softest = 1e5;              // Pa: softer than any soil
  for (const Material& material : project.materials) {
    const Place place = Place() / "materials" / material.name;
    if (material.density > 0 && (material.density < light || material.density > heavy))
      add(problems, Kind::warning, place / "density",
          "a density of " + number_text(material.density) + " kg/m³ is hardly that of rock",
          "rock has 1800 to 3200 kg/m³");
    if (material.young > 0 && material.young < softest)
      add(problems, Kind::warning, place / "young",
          "a Young's modulus of " + number_text(material.young) + " Pa is softer than any soil",
          "rock has 1e9 to 1e11 Pa: were MPa or GPa meant?");
  }
}

/// Whether something keeps the blocks from falling for ever.
bool is_held(const Project& project) {
  const auto may_be_fixed = [](BodyKind body) { return body == BodyKind::fixed || body == BodyKind::automatic; };
  return !project.constraints.empty() || project.gravity.isZero(0) ||
         std::any_of(project.solids.begin(), project.solids.end(),
                     [&](const auto& s) { return may_be_fixed(s.body); }) ||
         std::any_of(project.blocks.begin(), project.blocks.end(),
                     [&](const auto& block) { return block.body && may_be_fixed(*block.body); }) ||
         std::any_of(project.stages.begin(), project.stages.end(),
                     [](const Stage& stage) { return !stage.blocks.empty() || stage.constraints; });
}

void look_at_the_run(const Project& project, std::vector<ProjectProblem>& problems) {
  if (!project.solids.empty() && !is_held(project))
    add(problems, Kind::warning, Place() / "solids" / 0 / "body", "nothing is held, every block falls freely",
        "give a solid the body 'fixed', or support a block");
  if (project.gravity.isZero(0) && project.loads.empty() && project.velocities.empty())
    add(problems, Kind::warning, Place() / "gravity", "neither gravity nor a load nor a velocity moves anything",
        "give gravity, or a load");
  if (!project.stages.empty() && project.monitors.empty())
    add(problems, Kind::hint, Place() / "monitors", "there is no monitor: no history will be recorded",
        "add one on a block whose movement matters");
}

}  // namespace

std::vector<ProjectProblem> problems_of(const Project& project) {
  std::vector<ProjectProblem> problems;
  add_broken_rules(project, problems);
  look_at_materials(project, problems);
  look_at_the_run(project, problems);
  look_for_unused(project, problems);
  for (ProjectProblem& problem : problems_of_switched_effects(project)) problems.push_back(std::move(problem));
  std::stable_sort(problems.begin(), problems.end(), [](const auto& a, const auto& b) { return a.kind < b.kind; });
  return problems;
}

}  // namespace talus
