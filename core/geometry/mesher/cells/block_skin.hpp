#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesher/cells/cell_solid.hpp"
#include "model/rock/blocks.hpp"

namespace talus {

/// The triangles around a block of cells.
struct BlockSkin {
  std::vector<Vec3> more;                     ///< m, vertices beside those of the cells, numbered after them
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from outside
  std::vector<int> marks;                     ///< of each triangle, that of the cells' faces it is part of
};

/// How long edges are to be; `own` 0: as long as they come, from corners alone.
struct SkinSize {
  double own = 0;  ///< m
  std::span<const MeshRefinement> refinements{};
};

/// The surface of a set of cells: faces that only one of them has, those of one mark and one side of it made one and
/// triangulated (constrained Delaunay). Vertices that no edge of the block needs are left out; those that are left are
/// corners of every polygon that they lie on, so that the triangles close around the block. Throws InputError at
/// `place` where a face is a needle that cannot be divided so.
BlockSkin block_skin(const CellSolid& solid, std::span<const int> cells, const SkinSize& size,
                     const std::string& place);

}  // namespace talus
