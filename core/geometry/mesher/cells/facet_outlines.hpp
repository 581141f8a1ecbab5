#pragma once

#include <span>
#include <utility>
#include <vector>

#include "geometry/mesher/cells/cell_solid.hpp"

namespace talus {

/// Faces of a block on one plane, all seen from one side of it, as the directed edges around them.
struct FacetOutline {
  int mark = 0;
  Vec3 normal = Vec3::Zero();              ///< along the area, outwards
  std::vector<std::pair<int, int>> edges;  ///< of vertices, ascending; the area lies to the left
};

/// Of the surface of a set of cells: faces that only one of them has, those of one mark and one side of it made one.
/// Vertices in the middle of a straight edge of the block are left out.
std::vector<FacetOutline> facet_outlines(const CellSolid& solid, std::span<const int> cells);

/// Vertices that the outlines have.
int corner_count(const CellSolid& solid, std::span<const int> cells);

}  // namespace talus
