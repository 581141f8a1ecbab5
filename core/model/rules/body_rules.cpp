#include "model/rules/body_rules.hpp"

#include <algorithm>

#include "model/actions.hpp"
#include "model/require.hpp"

namespace talus {
namespace {

std::string quoted(BodyKind body) { return "'" + std::string(to_string(body)) + "'"; }

void check(const Constraint& constraint, const Place& place, const BodyOfBlock& body_of) {
  if (constraint.at) return;
  const auto known = body_of(constraint.block);
  require(!known || known->body == BodyKind::fixed || known->body == BodyKind::automatic, place,
          "moves block '" + constraint.block + "' as a whole, which is not fixed",
          "add the point 'at' that is held, or give the block the body 'fixed'");
  const auto& u = constraint.displacement;
  require(std::all_of(u.begin(), u.end(), [](const auto& component) { return component.has_value(); }), place,
          "moves block '" + constraint.block + "' as a whole and leaves a component free",
          "give a number for every component, 0 where the block stays");
}

/// A block that was made fixed because every stage holds it may be held by every stage.
void check_change_of_fixed(const BlockChange& change, const Place& place, bool chosen) {
  require(chosen && change.body == BodyKind::fixed, place / "name",
          "block '" + change.name + "' is built fixed: a stage can neither hold it nor let it go",
          "build it as a body that may move, 'tetrahedra' say, and hold it in the first stage by the body 'fixed'");
}

void check(const BlockChange& change, const Place& place, const BodyOfBlock& body_of) {
  const auto known = body_of(change.name);
  if (!known || known->body == BodyKind::automatic) return;
  if (known->body == BodyKind::fixed) return check_change_of_fixed(change, place, known->chosen);
  const bool lets_go = change.body == known->body || (known->chosen && change.body == BodyKind::automatic);
  require(
      change.body == BodyKind::fixed || lets_go, place / "body",
      "block '" + change.name + "' is built as " + quoted(known->body) + " and cannot become " + quoted(change.body),
      "use 'fixed' to hold it, or " + quoted(known->chosen ? BodyKind::automatic : known->body) + " to let it go");
}

void check(const Monitor& monitor, const Place& place, const BodyOfBlock& body_of) {
  const auto known = monitor.stress ? body_of(monitor.block) : std::nullopt;
  if (!known) return;
  require(known->body != BodyKind::fixed && known->body != BodyKind::rigid, place / "stress",
          "block '" + monitor.block + "' is " + quoted(known->body) + " and has no stress",
          "give it the body 'tetrahedra' (or 'affine' for one stress throughout), or let the monitor record no stress");
}

/// A fixed block may be named: the rock around it bears the stress too.
void check(const InSituStress& given, const Place& place, const BodyOfBlock& body_of) {
  for (std::size_t i = 0; i < given.blocks.size(); ++i) {
    const auto known = body_of(given.blocks[i]);
    require(!known || known->body != BodyKind::rigid, place / "blocks" / i,
            "block '" + given.blocks[i] + "' is 'rigid' and bears no stress",
            "give it the body 'tetrahedra' (or 'affine' for one stress throughout), or take it out of the list");
  }
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
  for (std::size_t i = 0; i < project.monitors.size(); ++i) {
    check(project.monitors[i], Place() / "monitors" / i, body_of);
  }
  for (std::size_t i = 0; i < project.in_situ.size(); ++i) {
    check(project.in_situ[i], Place() / "in_situ" / i, body_of);
  }
}

std::optional<KnownBody> body_before_cutting(const Project& project, const std::string& block) {
  const auto known = [](BodyKind body) { return KnownBody{body, body == BodyKind::automatic}; };
  const auto& solids = project.solids;
  for (const auto& named : project.blocks) {
    if (named.name != block) continue;
    if (named.body) return known(*named.body);
    const bool alike =
        std::all_of(solids.begin(), solids.end(), [&](const Solid& solid) { return solid.body == solids[0].body; });
    return alike && !solids.empty() ? std::optional(known(solids[0].body)) : std::nullopt;
  }
  for (const auto& solid : solids) {
    if (solid.name == block || solid.name == block.substr(0, block.rfind('.'))) return known(solid.body);
  }
  return std::nullopt;
}

}  // namespace talus
