#include "model/rules/references.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "base/error.hpp"
#include "model/actions.hpp"
#include "model/block_names.hpp"
#include "model/quantity.hpp"
#include "model/require.hpp"
#include "model/suggestion.hpp"

namespace talus {
namespace {

template <typename Things>
std::vector<std::string> names_of(const Things& things) {
  std::vector<std::string> names;
  for (const auto& thing : things) names.push_back(thing.name);
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Names are column heads, file names and words on screen.
void check_name(const std::string& name, const Place& place) {
  require(!name.empty(), place, "the name is empty", "give a name");
  const bool control = std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; });
  require(!control, place, "the name holds a control character", "use letters, digits and spaces");
}

using PlaceByName = std::map<std::string, Place>;

void check_unique(const std::string& name, const Place& place, PlaceByName& taken) {
  check_name(name, place);
  const auto [other, fresh] = taken.try_emplace(name, place);
  require(fresh, place, "the name '" + name + "' is taken by " + other->second.text(), "give each its own name");
}

template <typename Things>
void check_unique_names(const Things& things, const Place& list, PlaceByName& taken) {
  for (std::size_t i = 0; i < things.size(); ++i) check_unique(things[i].name, list / i / "name", taken);
}

void check_material(const Project& project, const std::string& material, const Place& place) {
  const auto names = names_of(project.materials);
  if (contains(names, material)) return;
  const std::string suggestion = suggest_name(material, names);
  require(false, place, "material '" + material + "' is not defined",
          "define it under materials" + (suggestion.empty() ? "" : ", or " + suggestion));
}

void check_joint(const Project& project, const std::string& joint, const Place& place) {
  const auto names = names_of(project.joints);
  if (contains(names, joint)) return;
  const std::string suggestion = suggest_name(joint, names);
  require(false, place, "joint '" + joint + "' is used here but not defined",
          "define it under joints" + (suggestion.empty() ? "" : ", or " + suggestion));
}

void check_joints(const Project& project) {
  for (std::size_t i = 0; i < project.cuts.size(); ++i) {
    const Place cut = Place() / "cuts" / i;
    check_joint(project, project.cuts[i].joint, cut / "joint");
    const auto& ends = project.cuts[i].ends_at;
    for (std::size_t k = 0; k < ends.size(); ++k) check_joint(project, ends[k], cut / "ends_at" / k);
  }
  for (std::size_t i = 0; i < project.interfaces.size(); ++i) {
    check_joint(project, project.interfaces[i].joint, Place() / "interfaces" / i / "joint");
  }
  for (std::size_t i = 0; i < project.stages.size(); ++i) {
    for (const auto& change : project.stages[i].joints) {
      check_joint(project, change.name, Place() / "stages" / i / "joints" / change.name);
    }
  }
  if (!project.default_joint.empty()) check_joint(project, project.default_joint, Place() / "default_joint");
}

void check_solids(const Project& project, const std::vector<std::string>& named, const Place& list) {
  const auto names = names_of(project.solids);
  for (std::size_t i = 0; i < named.size(); ++i)
    require(contains(names, named[i]), list / i, "there is no solid '" + named[i] + "'", suggest_name(named[i], names));
}

void check_solids(const Project& project) {
  for (std::size_t i = 0; i < project.cuts.size(); ++i)
    check_solids(project, project.cuts[i].solids, Place() / "cuts" / i / "solids");
  for (std::size_t i = 0; i < project.solids.size(); ++i)
    if (const auto* combined = std::get_if<CombinedShape>(&project.solids[i].shape))
      check_solids(project, combined->solids, Place() / "solids" / i / "combine" / "solids");
}

void check_expected_quantity(const Project& project, const std::string& text, const Place& place) {
  const auto quantity = parse_quantity(text);
  require(quantity.has_value(), place, "cannot read the quantity '" + text + "'",
          "write NAME.displacement.z or NAME.velocity.magnitude: a monitor or block, displacement or velocity, "
          "and x, y, z or magnitude; or NAME.stress.zz: a monitor, and xx, yy, zz, xy, yz or zx");
  if (!quantity || quantity->field != Quantity::Field::stress) return;
  const bool recorded = std::any_of(project.monitors.begin(), project.monitors.end(), [&](const Monitor& monitor) {
    return monitor.name == quantity->of && monitor.stress;
  });
  require(recorded, place, "'" + quantity->of + "' is no monitor that records stress",
          "name a monitor, and give it \"stress\": true");
}

bool is_excavated(const Project& project, const std::string& name) {
  return std::any_of(project.blocks.begin(), project.blocks.end(),
                     [&](const BlockOverride& block) { return block.removed && block.name == name; });
}

using BlockVisit = std::function<void(const Place&, const std::string&)>;

void visit_listed_blocks(const Project& project, const BlockVisit& visit) {
  for (std::size_t i = 0; i < project.in_situ.size(); ++i) {
    const auto& blocks = project.in_situ[i].blocks;
    for (std::size_t j = 0; j < blocks.size(); ++j) visit(Place() / "in_situ" / i / "blocks" / j, blocks[j]);
  }
  for (std::size_t i = 0; i < project.stages.size(); ++i) {
    const auto& changes = project.stages[i].blocks;
    for (std::size_t j = 0; j < changes.size(); ++j) {
      visit(Place() / "stages" / i / "blocks" / j / "name", changes[j].name);
    }
  }
}

}  // namespace

void validate_names(const Project& project) {
  PlaceByName materials, joints, blocks, stages, monitors;
  for (const auto& material : project.materials) {
    check_unique(material.name, Place() / "materials" / material.name, materials);
  }
  for (const auto& joint : project.joints) check_unique(joint.name, Place() / "joints" / joint.name, joints);
  // An override renames a block, so that solids and overrides share one set of names.
  check_unique_names(project.solids, Place() / "solids", blocks);
  check_unique_names(project.blocks, Place() / "blocks", blocks);
  check_unique_names(project.stages, Place() / "stages", stages);
  check_unique_names(project.monitors, Place() / "monitors", monitors);
}

void validate_default_joint(const Project& project) {
  if (!project.default_joint.empty()) return;
  const Place place = Place() / "default_joint";
  require(project.joints.empty(), place, "no joint is named for contacts that lie on no cut",
          "give the name of one of the joints");
  require(project.solids.size() < 2, place, "several solids may touch, and no joint says how they slide",
          "define a joint under joints and name it here");
}

void validate_references(const Project& project) {
  for (std::size_t i = 0; i < project.solids.size(); ++i) {
    check_material(project, project.solids[i].material, Place() / "solids" / i / "material");
  }
  check_joints(project);
  check_solids(project);
  for (std::size_t i = 0; i < project.blocks.size(); ++i) {
    const auto& material = project.blocks[i].material;
    if (material) check_material(project, *material, Place() / "blocks" / i / "material");
  }
  for (std::size_t i = 0; i < project.expect.size(); ++i) {
    check_expected_quantity(project, project.expect[i].quantity, Place() / "expect" / i / "quantity");
  }
  for_each_block_reference(project, [&](const Place& place, const std::string& name) {
    require(!is_excavated(project, name), place, "block '" + name + "' is removed before anything happens",
            "name another block, or take \"removed\" from it");
    if (may_be_block_name(project, name)) return;
    auto names = expected_block_names(project);
    if (place.pointer().starts_with("/expect")) {
      const auto monitors = names_of(project.monitors);
      names.insert(names.begin(), monitors.begin(), monitors.end());
    }
    require(false, place, "nothing is called '" + name + "'", suggest_name(name, names));
  });
}

void for_each_block_reference(const Project& project,
                              const std::function<void(const Place&, const std::string&)>& visit) {
  for (std::size_t i = 0; i < project.interfaces.size(); ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      visit(Place() / "interfaces" / i / "between" / j, project.interfaces[i].between[j]);
    }
  }
  const auto visit_list = [&](const auto& things, const char* list) {
    for (std::size_t i = 0; i < things.size(); ++i) visit(Place() / list / i / "block", things[i].block);
  };
  for_each_constraint(project, [&](const Place& place, const Constraint& c) { visit(place / "block", c.block); });
  for_each_load(project, [&](const Place& place, const PointLoad& load) { visit(place / "block", load.block); });
  visit_list(project.velocities, "velocities");
  visit_list(project.monitors, "monitors");
  visit_listed_blocks(project, visit);

  const auto monitors = names_of(project.monitors);
  for (std::size_t i = 0; i < project.expect.size(); ++i) {
    const auto quantity = parse_quantity(project.expect[i].quantity);
    if (quantity && !contains(monitors, quantity->of)) visit(Place() / "expect" / i / "quantity", quantity->of);
  }
}

}  // namespace talus
