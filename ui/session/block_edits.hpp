#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "model/rock/body_kind.hpp"
#include "removability/block_facts.hpp"
#include "session/current_project.hpp"

namespace talus {

/// What is done to several blocks at once: each one step that can be undone. Blocks are indices into the blocks as they
/// were cut; the project names each by a point that surely lies in it. Each throws InputError, and changes nothing,
/// where the project would be impossible.
namespace block_edits {

using Blocks = std::vector<int>;

/// Body and material of each as the project says them now, which the blocks may not have been cut with yet.
std::vector<BlockOverride> said(CurrentProject& project, const Blocks& blocks);

/// `{n}` of the pattern becomes 1, 2, … in the order of the blocks; several need it. Whoever names a block follows.
void rename(CurrentProject& project, const Blocks& blocks, const QString& pattern);
/// Nothing given: as their solids have it.
void setBody(CurrentProject& project, const Blocks& blocks, std::optional<BodyKind> body);
void setMaterial(CurrentProject& project, const Blocks& blocks, const std::optional<std::string>& material);
void setMeshSize(CurrentProject& project, const Blocks& blocks, std::optional<double> metres);

/// They are cut from now on, and left out.
void excavate(CurrentProject& project, const Blocks& blocks);
/// Names of those that are left out, in the project's order.
std::vector<std::string> excavated(const CurrentProject& project);
void bringBack(CurrentProject& project, const std::vector<std::string>& names);

/// They become one block with the properties of the first. They must hang together.
void merge(CurrentProject& project, const Blocks& blocks, const std::vector<BlockFacts>& facts);

}  // namespace block_edits

}  // namespace talus
