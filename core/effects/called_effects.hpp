#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "effects/effect_kind.hpp"
#include "model/project.hpp"

namespace talus {

struct BlockSystem;

/// Whether a scene calls for an effect, and why or why not.
struct EffectStatus {
  EffectKind kind = EffectKind::elasticity;
  bool active = false;
  std::string reason;
};

/// Every kind once, in their order: whether a stage calls for it, or the project forces it on or off. `alone`: so many
/// of the blocks that may move can reach no other one within the run. Costs no solving.
std::vector<EffectStatus> called_effects(const Project& project, const BlockSystem& system, std::size_t alone = 0);

/// Whether points of blocks are held in a project, as it holds in a stage.
bool holds_points(const Project& project);

}  // namespace talus
