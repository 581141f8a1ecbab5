#include "model/body_rules.hpp"

#include <algorithm>

#include "model/actions.hpp"
#include "model/require.hpp"

namespace talus {
namespace {

std::string quoted(BodyKind body) { return "'" + std::string(to_string(body)) + "'"; }

void check(const Constraint& constraint, const Place& place, const BodyOfBlock& body_of) {
  if (constraint.at) return;
  const auto body = body_of(constraint.block);
  require(!body || *body == BodyKind::fixed, place,
          "moves block '" + constraint.block + "' as a whole, which is not fixed",
          "add the point 'at' that is held, or give the block the body 'fixed'");
  const auto& u = constraint.displacement;
  require(std::all_of(u.begin(), u.end(), [](const auto& component) { return component.has_value(); }), place,
          "moves block '" + constraint.block + "' as a whole and leaves a component free",
          "give a number for every component, 0 where the block stays");
}

void check(const BlockChange& change, const Place& place, const BodyOfBlock& body_of) {
  const auto built = body_of(change.name);
  if (!built) return;
  require(*built != BodyKind::fixed, place / "name",
          "block '" + change.name + "' is built fixed: a stage can neither hold it nor let it go",
          "build it as 'tetrahedra', and hold it with \"body\": \"fixed\" in the first stage");
  require(change.body == BodyKind::fixed || change.body == *built, place / "body",
          "block '" + change.name + "' is built as " + quoted(*built) + " and cannot become " + quoted(change.body),
          "use 'fixed' to hold it, or " + quoted(*built) + " to let it go");
}

}  // namespace

void check_bodies(const Project& project, const BodyOfBlock& body_of) {
  for_each_constraint(project, [&](const Place& place, const Constraint& c) { check(c, place, body_of); });
  for (std::size_t i = 0; i < project.stages.size(); ++i) {
    const auto& changes = project.stages[i].blocks;
    for (std::size_t k = 0; k < changes.size(); ++k) {
      check(changes[k], Place() / "stages" / i / "blocks" / k, body_of);
    }
  }
}

std::optional<BodyKind> body_before_cutting(const Project& project, const std::string& block) {
  const auto& solids = project.solids;
  for (const auto& named : project.blocks) {
    if (named.name != block) continue;
    const bool alike =
        std::all_of(solids.begin(), solids.end(), [&](const Solid& solid) { return solid.body == solids[0].body; });
    return named.body || !alike || solids.empty() ? named.body : solids[0].body;
  }
  for (const auto& solid : solids) {
    if (solid.name == block || solid.name == block.substr(0, block.rfind('.'))) return solid.body;
  }
  return std::nullopt;
}

}  // namespace talus
