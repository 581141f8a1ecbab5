#include "model/rules/validate.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.hpp"
#include "base/units.hpp"
#include "model/actions.hpp"
#include "model/number_text.hpp"
#include "model/place.hpp"
#include "model/require.hpp"
#include "model/rules/action_rules.hpp"
#include "model/rules/block_rules.hpp"
#include "model/rules/body_rules.hpp"
#include "model/rules/cut_rules.hpp"
#include "model/rules/joint_rules.hpp"
#include "model/rules/references.hpp"
#include "model/rules/solid_rules.hpp"
#include "model/rules/solver_rules.hpp"
#include "model/rules/stage_rules.hpp"
#include "model/suggestion.hpp"

namespace talus {
namespace {

void check(const RockStrength& strength, const Place& place) {
  check_friction_angle(strength.friction_angle, place / "friction_angle");
  require_not_negative(strength.cohesion, place / "cohesion", "cohesion", "Pa");
  if (!strength.tensile_strength) return;
  require_not_negative(*strength.tensile_strength, place / "tensile_strength", "tensile strength", "Pa");
  const double slope = std::tan(radians(strength.friction_angle));
  require(*strength.tensile_strength * slope <= strength.cohesion * (1 + 1e-9), place / "tensile_strength",
          "the tensile strength, " + number_text(*strength.tensile_strength) +
              " Pa, lies beyond the apex of the shear "
              "strength, cohesion / tan(friction angle) = " +
              number_text(strength.cohesion / slope) + " Pa",
          "give at most that, or leave it out");
}

void check(const Material& material) {
  const Place place = Place() / "materials" / material.name;
  require_positive(material.density, place / "density", "density", "kg/m³");
  require_positive(material.young, place / "young", "Young's modulus", "Pa");
  require_finite(material.poisson, place / "poisson");
  require(material.poisson > -1 && material.poisson < 0.5, place / "poisson",
          "Poisson's ratio must lie between -1 and 0.5, is " + number_text(material.poisson),
          "rock has 0.1 to 0.35; use 0.49 for nearly incompressible");
  require_not_negative(material.damping, place / "damping", "damping", "1/s");
  if (material.strength) check(*material.strength, place / "strength");
  require(material.law == MaterialLaw::linear || material.poisson >= 0, place / "poisson",
          "a neo-hookean material needs a Poisson's ratio of at least 0, is " + number_text(material.poisson),
          "squeezed to nothing it would give energy; give it another ratio, or the linear law");
}

void check_law(const Material& material, const SolverSettings& solver) {
  require(material.law == MaterialLaw::linear || solver.strain == Strain::corotational,
          Place() / "materials" / material.name / "law",
          "a neo-hookean material is strained from its undeformed shape, which incremental strain does not know",
          "set solver.strain to corotational, or the law to linear");
}

void check(const Interface& interface, const Place& place) {
  require(interface.between[0] != interface.between[1], place / "between", "names the same block twice",
          "name the two blocks that touch");
}

void check(const Monitor& monitor, const Place& place) { require_finite(monitor.at, place / "at"); }

double end_time(const Project& project) {
  double time = 0;
  for (const auto& stage : project.stages) {
    time += stage.steps ? *stage.steps * stage.time_step : stage.duration.value_or(0);
  }
  return time;
}

void check_expectation(const Expectation& expectation, const Place& place, double end) {
  constexpr double rounding = 1e-9;  // of the end, in the sum of many time steps
  require_not_negative(expectation.time, place / "time", "time", "seconds");
  require(expectation.time <= end * (1 + rounding), place / "time",
          "lies after the end of the run, " + number_text(end) + " s", "lengthen a stage or expect it earlier");
  if (expectation.since) {
    require_not_negative(*expectation.since, place / "since", "since", "seconds");
    require(*expectation.since < expectation.time, place / "since", "must be earlier than time",
            "count the change from a moment before " + number_text(expectation.time) + " s");
  }
  require_finite(expectation.value, place / "value");
  require_positive(expectation.tolerance, place / "tolerance", "tolerance",
                   "the value (of metres or m/s where the value is 0)");
}

template <typename Things>
void check_each(const Things& things, const char* list) {
  for (std::size_t i = 0; i < things.size(); ++i) check(things[i], Place() / list / i);
}

void require_solids(const Project& project) {
  require(!project.solids.empty(), Place() / "solids", "the project has no solid", "add a box, a polyhedron or a file");
}

}  // namespace

void validate(const Project& project) {
  require_solids(project);
  require(!project.stages.empty(), Place() / "stages", "the project has no stage",
          "add one with a type, a time_step, and steps or a duration");
  validate_what_is_there(project);
  check_combined_solids(project);
  validate_default_joint(project);
}

void validate_for_cutting(const Project& project) {
  require_solids(project);
  validate_what_is_there(project);
  check_combined_solids(project);
}

void validate_what_is_there(const Project& project) {
  require_finite(project.gravity, Place() / "gravity");
  require_finite(project.origin, Place() / "origin");
  validate_names(project);
  for (const auto& material : project.materials) {
    check(material);
    check_law(material, project.solver);
  }
  for (const auto& joint : project.joints) check(joint, Place() / "joints" / joint.name);
  check_each(project.solids, "solids");
  check_each(project.cuts, "cuts");
  check_each(project.blocks, "blocks");
  check_each(project.merges, "merges");
  check(project.splinters, Place() / "splinters");
  check(project.mesh, Place() / "mesh");
  check_each(project.interfaces, "interfaces");
  for_each_constraint(project, [](const Place& place, const Constraint& constraint) { check(constraint, place); });
  for_each_load(project, [](const Place& place, const PointLoad& load) { check(load, place); });
  check_each(project.velocities, "velocities");
  check_each(project.in_situ, "in_situ");
  check_stages(project);
  check(project.solver);
  check_each(project.monitors, "monitors");
  for (std::size_t i = 0; i < project.expect.size(); ++i) {
    check_expectation(project.expect[i], Place() / "expect" / i, end_time(project));
  }
  require_positive(project.output.every, Place() / "output" / "every", "the time between frames", "seconds");
  validate_references(project);
  check_bodies(project, [&](const std::string& block) { return body_before_cutting(project, block); });
}

void validate_against_blocks(const Project& project, const std::vector<BuiltBlock>& blocks) {
  std::map<std::string, KnownBody> bodies;
  std::vector<std::string> names;
  for (const auto& [name, body, chosen] : blocks) {
    require(bodies.emplace(name, KnownBody{body, chosen}).second, Place() / "solids",
            "two blocks come out with the name '" + name + "'",
            "rename a solid, or name one of the blocks under blocks");
    names.push_back(name);
  }
  for_each_block_reference(project, [&](const Place& place, const std::string& name) {
    if (bodies.contains(name)) return;
    throw InputError(place.text(), "no block is called '" + name + "' once the solids are cut",
                     suggest_name(name, names));
  });
  check_bodies(project, [&](const std::string& block) { return bodies.at(block); });
}

}  // namespace talus
