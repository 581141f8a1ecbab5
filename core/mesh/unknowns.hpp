#pragma once

#include "mesh/block.hpp"

namespace talus {

/// Of its motion; none where it is fixed.
inline long unknowns_of(const Block& block) {
  if (block.body == BodyKind::fixed) return 0;
  if (block.body == BodyKind::rigid) return 6;
  return block.body == BodyKind::affine ? 12 : 3 * static_cast<long>(block.mesh.nodes.size());
}

}  // namespace talus
