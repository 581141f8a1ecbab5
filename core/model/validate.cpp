#include "model/validate.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>

#include "base/error.hpp"
#include "model/action_rules.hpp"
#include "model/actions.hpp"
#include "model/body_rules.hpp"
#include "model/joint_rules.hpp"
#include "model/number_text.hpp"
#include "model/place.hpp"
#include "model/polyhedron.hpp"
#include "model/references.hpp"
#include "model/require.hpp"
#include "model/solver_rules.hpp"
#include "model/stage_rules.hpp"
#include "model/suggestion.hpp"

namespace talus {
namespace {

void check(const Material& material) {
  const Place place = Place() / "materials" / material.name;
  require_positive(material.density, place / "density", "density", "kg/m³");
  require_positive(material.young, place / "young", "Young's modulus", "Pa");
  require_finite(material.poisson, place / "poisson");
  require(material.poisson > -1 && material.poisson < 0.5, place / "poisson",
          "Poisson's ratio must lie between -1 and 0.5, is " + number_text(material.poisson),
          "rock has 0.1 to 0.35; use 0.49 for nearly incompressible");
  require_not_negative(material.damping, place / "damping", "damping", "1/s");
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

void check_shape(const BoxShape& box, const Place& solid) {
  const Place place = solid / "box";
  require_finite(box.min, place / "min");
  require_finite(box.max, place / "max");
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    require(box.min[axis] < box.max[axis], place / "max" / i,
            "must be greater than min: " + number_text(box.max[axis]) + " against " + number_text(box.min[axis]),
            "swap the two corners' values or give the box a thickness");
  }
}

void check_shape(const PolyhedronShape& shape, const Place& solid) {
  stop_at_first_broken([&] { validate_polyhedron(shape, solid / "polyhedron"); });
}

void check_shape(const FileShape& shape, const Place& solid) {
  const Place place = solid / "file";
  require(!shape.path.empty(), place, "the file name is empty", "name a STEP file beside the project");
  std::string ending = std::filesystem::path(shape.path).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  require(ending == ".step" || ending == ".stp", place, "this version imports STEP files only, not '" + ending + "'",
          "export the solid as STEP (.step or .stp)");
  require_positive(shape.scale, solid / "scale", "scale", "metres per unit of the file");
}

void check_mesh_size(const std::optional<double>& mesh_size, const Place& place) {
  if (mesh_size) require_positive(*mesh_size, place, "mesh size", "m");
}

void check(const Solid& solid, const Place& place) {
  std::visit([&](const auto& shape) { check_shape(shape, place); }, solid.shape);
  check_mesh_size(solid.mesh_size, place / "mesh_size");
}

/// What chance decides of a set of joints.
void check_drawing(const Cut& cut, const Place& place) {
  const SpacingLaw law = cut.spacing_law;
  const std::string name(to_string(law));
  const bool has_law = law != SpacingLaw::equal;
  require(!has_law || cut.spacing, place / "spacing_law", "a law of spacing needs a spacing, its mean",
          "add 'spacing' in m and 'count'");
  require(!cut.spacing_deviation || law == SpacingLaw::normal || law == SpacingLaw::lognormal,
          place / "spacing_deviation", "the law " + name + " has no standard deviation to give",
          "leave it out, or take the law normal or lognormal");
  if (cut.spacing_deviation)
    require_positive(*cut.spacing_deviation, place / "spacing_deviation", "standard deviation", "m");
  if (cut.fisher_kappa)
    require(*cut.fisher_kappa > 0 && std::isfinite(*cut.fisher_kappa), place / "fisher_kappa",
            "Fisher's κ must be greater than 0, is " + number_text(*cut.fisher_kappa),
            "give a positive number: 20 scatters much, 500 little");
  require(!cut.seed || has_law || cut.fisher_kappa, place / "seed", "there is nothing to draw",
          "add 'spacing_law' or 'fisher_kappa', or leave the seed out");
  require(cut.seed.value_or(1) >= 0, place / "seed", "a seed is not negative", "give 0, 1, 2 …");
}

void check(const Cut& cut, const Place& place) {
  require_finite(cut.dip, place / "dip");
  require(cut.dip >= 0 && cut.dip <= 90, place / "dip", "dip must be 0 to 90, is " + number_text(cut.dip),
          "measure it in degrees from the horizontal, and turn dip_direction by 180 for the other side");
  require_finite(cut.dip_direction, place / "dip_direction");
  require(cut.dip_direction >= 0 && cut.dip_direction <= 360, place / "dip_direction",
          "dip direction must be 0 to 360, is " + number_text(cut.dip_direction),
          "measure it in degrees clockwise from north (+y)");
  require_finite(cut.through, place / "through");
  require(cut.spacing.has_value() == cut.count.has_value(), place, "spacing and count belong together",
          cut.spacing ? "add 'count', the number of parallel planes" : "add 'spacing' in m");
  if (cut.spacing) require_positive(*cut.spacing, place / "spacing", "spacing", "m");
  if (cut.count) {
    require(*cut.count >= 1, place / "count", "count must be at least 1, is " + std::to_string(*cut.count),
            "give the number of parallel planes");
  }
  check_drawing(cut, place);
}

void check(const BlockOverride& block, const Place& place) {
  require_finite(block.at, place / "at");
  check_mesh_size(block.mesh_size, place / "mesh_size");
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
  validate_default_joint(project);
}

void validate_for_cutting(const Project& project) {
  require_solids(project);
  validate_what_is_there(project);
}

void validate_what_is_there(const Project& project) {
  require_finite(project.gravity, Place() / "gravity");
  validate_names(project);
  for (const auto& material : project.materials) {
    check(material);
    check_law(material, project.solver);
  }
  for (const auto& joint : project.joints) check(joint, Place() / "joints" / joint.name);
  check_each(project.solids, "solids");
  check_each(project.cuts, "cuts");
  check_each(project.blocks, "blocks");
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
