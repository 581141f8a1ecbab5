#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "geometry/mesher/cells/cell_complex.hpp"

namespace talus {

/// The three lowest corners of a face and how many it has: the same for both cells that have it, and for no other,
/// since faces of convex cells that are not the same share an edge at most.
using FaceKey = std::array<int, 4>;

inline FaceKey key_of(const CellFace& face) {
  FaceKey key{};
  std::partial_sort_copy(face.corners.begin(), face.corners.end(), key.begin(), key.begin() + 3);
  key[3] = static_cast<int>(face.corners.size());
  return key;
}

}  // namespace talus
